"""Programs of a session that a test runs to their end."""


def run(session, main, **options):
    process = session.start(main, name=options.pop("name", "prog"), **options)
    return process.wait(30), process
