# docker build -t washout . && docker run --rm -v "$PWD:/work" washout solve designs/twist-v2.toml
FROM rust:1-slim AS build
COPY . /washout
RUN cargo install --locked --path /washout --root /usr/local

FROM debian:stable-slim
COPY --from=build /usr/local/bin/washout /usr/local/bin/washout
WORKDIR /work
ENTRYPOINT ["washout"]
