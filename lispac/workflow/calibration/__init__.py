"""From seeds to the boresight: targets, estimation, alternative methods."""
