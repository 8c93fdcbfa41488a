"""Check robot descriptions in tests of ament packages."""
