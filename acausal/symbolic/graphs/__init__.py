"""Graph algorithms of the symbolic core: integers only, knowing neither expressions nor names."""
