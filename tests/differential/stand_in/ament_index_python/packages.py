"""Look packages up in AMENT_PREFIX_PATH."""
import os


class PackageNotFoundError(KeyError):
    """No prefix has the package."""


def get_package_share_directory(package):
    """The share folder of the first prefix whose index names `package`."""
    prefixes = [p for p in os.environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep) if p]
    for prefix in prefixes:
        if os.path.exists(os.path.join(prefix, 'share/ament_index/resource_index/packages', package)):
            return os.path.join(prefix, 'share', package)
    raise PackageNotFoundError('package %r not found, searching: %r' % (package, prefixes))
