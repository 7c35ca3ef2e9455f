"""``python -m wraparc``: the command line."""

from wraparc.cli import main

if __name__ == "__main__":
    main()
