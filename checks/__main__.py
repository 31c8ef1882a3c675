"""`python -m checks` is the command `kminusone`."""

from checks.cli import main

if __name__ == "__main__":
    main()
