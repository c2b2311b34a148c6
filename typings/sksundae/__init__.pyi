"""The part of scikit-sundae 1.2 that acausal uses; the package has no type information of its own."""

from sksundae import cvode as cvode
from sksundae import ida as ida
