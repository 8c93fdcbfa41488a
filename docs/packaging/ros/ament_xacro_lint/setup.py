"""The linter as a package of ament."""

from setuptools import find_packages, setup

NAME = "ament_xacro_lint"

setup(
    name=NAME,
    version="0.1.0",
    packages=find_packages(exclude=["test"]),
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=False,
    maintainer="The contributors of xacro-lint",
    maintainer_email="maintainer@example.org",
    description="Check robot descriptions (xacro and URDF) in tests of ament packages, with xacro-lint",
    license="MIT OR Apache-2.0",
    extras_require={"test": ["pytest"]},
    entry_points={"console_scripts": [f"{NAME} = {NAME}.main:main"]},
)
