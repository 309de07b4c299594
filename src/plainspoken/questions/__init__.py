"""What is asked about a mission, and what is answered: claims with instants, then words."""
