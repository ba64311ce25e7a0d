"""Services of ros_gz_interfaces, made from their definition files when first used."""

from coursekit.interfaces.face import expose

__getattr__, __dir__, __all__ = expose(__name__, __file__)
