"""What balancing a mechanism computes."""
