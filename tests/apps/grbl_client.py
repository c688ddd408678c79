# SPDX-License-Identifier: MIT
"""`softcnc serve`, and connections to it, for the tests of the senders of grbl."""
import os
import re
import select
import signal
import socket
import subprocess
import termios
import time
import tty


class Line:
    """A connection: bytes out, lines in."""

    def __init__(self, descriptor, owner=None):
        self.descriptor, self.owner, self.heard = descriptor, owner, b""

    def send(self, data):
        os.write(self.descriptor, data)

    def line(self, seconds=10):
        end = time.monotonic() + seconds
        while b"\r\n" not in self.heard:
            ready, _, _ = select.select([self.descriptor], [], [], max(0, end - time.monotonic()))
            if not ready:
                raise AssertionError(f"nothing heard but {self.heard!r}")
            data = os.read(self.descriptor, 65536)
            if not data:
                return None
            self.heard += data
        line, self.heard = self.heard.split(b"\r\n", 1)
        return line.decode()

    def ask(self, data, seconds=10):
        """All lines up to the answer."""
        self.send(data)
        lines = []
        while not lines or not re.fullmatch(r"ok|error:\d+|<.*>", lines[-1]):
            lines.append(self.line(seconds))
        return lines

    def report(self):
        return self.ask(b"?")[-1]


def by_tcp(port):
    connection = socket.create_connection(("127.0.0.1", port))
    line = Line(connection.fileno(), connection)
    assert line.line() == "" and line.line().startswith("Grbl 1.1"), "no banner"
    return line


def by_terminal(link):
    descriptor = os.open(link, os.O_RDWR | os.O_NOCTTY)
    tty.setraw(descriptor, termios.TCSANOW)
    return Line(descriptor)


class Server:
    def __init__(self, softcnc, folder, *options):
        self.link = str(folder / "grbl")
        self.process = subprocess.Popen(
            [softcnc, "serve", "--pty", self.link, "--tcp", "0", *options], cwd=folder,
            stderr=subprocess.PIPE, text=True)
        said = ""
        while "serves grbl" not in said:
            said = self.process.stderr.readline()
            assert said, "it has ended"
        self.port = int(re.search(r"127\.0\.0\.1:(\d+)", said).group(1))

    def end(self):
        self.process.send_signal(signal.SIGTERM)
        status = self.process.wait(20)
        self.process.stderr.close()
        assert status == 128 + signal.SIGTERM, status
