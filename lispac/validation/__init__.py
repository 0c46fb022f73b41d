"""How far apart the lines were on what took no part, and how close they are."""
