"""Generator of random xacro programs; see ../README.md."""
