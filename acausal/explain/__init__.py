"""What the compiler did to a model and why, for people and programs: `acausal explain`."""
