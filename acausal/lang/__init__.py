"""The language front end: text, AST, instance tree, flat model."""
