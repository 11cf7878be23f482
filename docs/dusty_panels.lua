-- What if dust covers half of the panels from here on? A script for `lsos-host branch --with`.
sim:shade('SEV1', 0.5)
