"""What takes minutes, the network and root: started by hand before a release."""
