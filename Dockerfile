# SPDX-License-Identifier: MIT
# An image in which softcnc is installed, from its package:
#   scripts/package && docker build --tag softcnc --file Dockerfile build/packages
FROM debian:12-slim
COPY softcnc_*.deb /tmp/
RUN apt-get update && \
    apt-get install --yes --no-install-recommends /tmp/softcnc_*.deb && \
    rm -rf /var/lib/apt/lists/* /tmp/softcnc_*.deb
CMD ["softcnc", "--help"]
