"""What the Modelica Standard Library calls by `external "C"`, implemented here in a table by name.

Nothing outside acausal is ever called: a name that is not in the table is refused by the front end.
"""
