"""What a program logged."""


def said(process):
    """The log without its stamps."""
    return [line.split("]: ", 1)[1] for line in process.output.splitlines() if "]: " in line]
