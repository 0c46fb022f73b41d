"""Lines as text without a stated format: one point a row, columns named by the user."""

ASSUMPTIONS = ("text coordinates are metres in the LiDAR frame",)
