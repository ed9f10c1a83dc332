#!/usr/bin/env bash
# Builds the image of the Dockerfile and runs it, without a daemon: by buildah, with a chroot for a container. Where the registry cannot be reached, its base is made of Debian's own packages, the essential ones and apt, which is what debian:12-slim is.
# Then the Job's line makes six creatures in two pods of the image, without rights, and each file has the bytes that the program makes outside. Needs root, Debian's buildah and, for a base of its own, debootstrap.
#   container-rehearsal.sh FOLDER
set -euo pipefail
place=$(mkdir -p "$1" && realpath "$1"); here=$(dirname "$(realpath "$0")"); cd "$place"
export BUILDAH_ISOLATION=chroot CONTAINERS_REGISTRIES_CONF=$place/registries.conf
buildah() { command buildah --root "$place/images" --runroot "$place/run" --storage-driver vfs "$@"; }
echo 'unqualified-search-registries = ["docker.io"]' > registries.conf

# As the head of the Dockerfile says.
mkdir -p context && cp "$here/Dockerfile" "$here/.dockerignore" context
dotnet publish "$here/../CreatureGen.Console" -c Release -r linux-x64 --self-contained -p:OneFile=true -o context/image --nologo -v q

base=$(sed -n 's/^FROM //p' context/Dockerfile)
if ! buildah inspect --type image "$base" > /dev/null 2>&1 && ! buildah pull "$base" 2> pull.log; then
    echo "no $base from its registry; making one of Debian's packages"
    [ -d base/etc ] || debootstrap --variant=minbase bookworm base > debootstrap.log
    scratch=$(buildah from scratch)
    buildah add -q "$scratch" base / > /dev/null
    buildah commit -q --rm "$scratch" "docker.io/library/$base" > /dev/null
fi

buildah build -q --pull=never -t creaturegen:0.1.0 context > /dev/null
buildah images
entry=$(buildah inspect --type image --format '{{index .OCIv1.Config.Entrypoint 0}}' creaturegen:0.1.0)
user=$(buildah inspect --type image --format '{{.OCIv1.Config.User}}' creaturegen:0.1.0)
line=$(sed -n 's/^ *args: \[\(.*\)\]/\1/p' "$here/kubernetes/job.yaml" | tr -d ',"' | sed 's/1-100000/1-6/; s/--shards 64/--shards 2/')
rm -rf creatures outside; mkdir creatures; chown "$user" creatures
for index in 0 1; do
    pod=$(buildah from --pull=never creaturegen:0.1.0)
    buildah run --env "JOB_COMPLETION_INDEX=$index" --volume "$place/creatures:/creatures" "$pod" -- "$entry" $line
    buildah rm "$pod" > /dev/null
done

context/image/creaturegen merge creatures
context/image/creaturegen generate --seeds 1-6 --out outside --manifest --quiet
cmp creatures/manifest.jsonl outside/manifest.jsonl
context/image/creaturegen verify --manifest creatures
echo "the image is built and runs as $user: six creatures in two pods, byte for byte those made outside"
