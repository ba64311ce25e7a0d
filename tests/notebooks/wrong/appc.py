"""Appendix C."""

_WHERE = """def where(uri):
    {check}
    name, _, rest = uri.removeprefix("package://").{cut}("/")
    return {answer}
"""
_CHECK = 'if not uri.startswith("package://"): raise ValueError(uri)'
_FILES = """edit(
    "src/c_signs/setup.py",
    "        ('share/' + package_name + '/meshes', glob('meshes/*.stl')),",
    "        ('share/' + package_name + '/meshes', glob('meshes/*.stl')),\\n"
    "        ('share/' + package_name + '{folder}', glob('{files}')),",
)
"""
_PORTABLE = """import posixpath

def portable(name, package, root, near):
    if name.startswith("package://"):
        return {kept}
    path = {path}
    root = posixpath.normpath(root)
    if not path.startswith(root{slash}):
        {refuse}
    return "package://" + package + "/" + path[len(root) + 1:]
"""
_PATH = 'posixpath.normpath(posixpath.join(near, name.removeprefix("file://")))'
_RAISE = "raise ValueError(path)"

WRONG = {
    "appc.q1": [
        _WHERE.format(check=_CHECK, cut="rpartition", answer="os.path.join(get_package_share_directory(name), rest)"),
        _WHERE.format(check=_CHECK, cut="partition", answer="os.path.join(get_package_prefix(name), rest)"),
        _WHERE.format(check="", cut="partition", answer="os.path.join(get_package_share_directory(name), rest)"),
        _WHERE.format(check=_CHECK, cut="partition", answer="find_file(uri)"),
    ],
    "appc.q2": [
        "pass",
        _FILES.format(folder="/urdf", files="urdf/*"),
        _FILES.format(folder="/meshes", files="meshes/large/*.stl"),
    ],
    "appc.q3": [
        _PORTABLE.format(kept="name", path=_PATH, slash="", refuse=_RAISE),
        _PORTABLE.format(kept="name", path=_PATH, slash=' + "/"', refuse="return name"),
        _PORTABLE.format(kept="name", path="posixpath.join(near, name)", slash=' + "/"', refuse=_RAISE),
        _PORTABLE.format(kept="name.replace('other', 'vera')", path=_PATH, slash=' + "/"', refuse=_RAISE),
    ],
}
