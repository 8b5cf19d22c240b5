"""Whether a results file holds what the program wrote, column by column, and nothing but that: as src/store/detail/walk.cpp
and digests.cpp have it. A seal over the whole file can be made anew by whoever edits it; these lists have to be, too."""

import hashlib

from .errors import Error, require

require("numpy", "h5py", what="results files are read with it")

import h5py  # noqa: E402
import numpy as np  # noqa: E402
from h5py import h5d, h5g, h5l, h5o, h5s, h5t  # noqa: E402

LIST, OF_ALL = "/digests/objects", "content_sha256"
AT_ONCE = 1 << 20  # bytes
STRETCH_BYTES, STRETCH = "stretch_bytes", 4 << 20  # columns longer than it are hashed in parts, in files that say so
PLUGINS = 256  # numbers of filters from here on are of libraries that HDF5 would have to look for
MOST_NAMED = 3
ADVICE = "Give the file that overturn wrote"


def objects_of(file):
    """By path, every object of an open h5py.File. Raises Error at a link to elsewhere, a group that is reached twice and a
    column that is stored elsewhere or through a plugin: before any of it is followed or read."""
    found, groups, seen = {"/": file["/"].id}, ["/"], set()
    while groups:
        path = groups.pop()
        group = found[path]
        address = h5o.get_info(group).addr
        if address in seen:
            raise Error(f"{path} is reached by two names (results know no such group). {ADVICE}")
        seen.add(address)
        for name in group:
            place = path.rstrip("/") + "/" + name.decode(errors="surrogateescape")
            if group.links.get_info(name).type != h5l.TYPE_HARD:
                raise Error(f"{place} is a link to elsewhere (a results file must not refer to other files). {ADVICE}")
            found[place] = h5o.open(group, name)
            if isinstance(found[place], h5g.GroupID):
                groups.append(place)
            elif isinstance(found[place], h5d.DatasetID):
                _require_stored_within(found[place], place)
    return found


def _require_stored_within(dataset, path):
    made = dataset.get_create_plist()
    if made.get_external_count() > 0 or made.get_layout() == h5d.VIRTUAL:
        raise Error(f"{path} is stored in another file (a results file must not refer to other files). {ADVICE}")
    for i in range(made.get_nfilters()):
        if (number := made.get_filter(i)[0]) >= PLUGINS:
            raise Error(f"{path} is stored through filter {number} (a plugin, which is never loaded). {ADVICE}")


def faults_of(file, objects):
    """What is not as it was written ("/trials/v_wes changed, /trials/x is gone"); empty where all is."""
    if LIST not in objects:
        return f"{LIST} is gone"
    told = bytes(np.asarray(file[LIST][...], dtype=np.uint8))
    if file.attrs.get(OF_ALL) not in (hashlib.sha256(told).hexdigest(), hashlib.sha256(told).hexdigest().encode()):
        return f"{LIST} is not as it was written"
    lines = (line.split("  ", 1) for line in told.decode(errors="surrogateescape").splitlines())
    before = {path: digest for digest, path in lines}
    places = {h5o.get_info(each).addr: path for path, each in sorted(objects.items(), reverse=True)}
    stretched = STRETCH_BYTES in file[LIST].attrs
    now = {path.replace("\n", " "): _digest(each, path, file, places, stretched) for path, each in objects.items()
           if path != "/digests" and not path.startswith("/digests/")}
    names = [path + (" changed" if path in now else " is gone")
             for path in sorted(before) if now.get(path) != before[path]]
    names += [path + " is new" for path in sorted(now) if path not in before]
    more = len(names) - MOST_NAMED
    return ", ".join(names[:MOST_NAMED]) + (f" and {more} more" if more > 0 else "")


class _Hash:
    def __init__(self):
        self.sha = hashlib.sha256()

    def text(self, text):
        content = text if isinstance(text, bytes) else text.encode(errors="surrogateescape")
        self.sha.update(b"%d:%s" % (len(content), content))


def _digest(each, path, file, places, stretched):
    digest = _Hash()
    kind = "group" if isinstance(each, h5g.GroupID) else "dataset" if isinstance(each, h5d.DatasetID) else "type"
    digest.text(kind)
    for name in sorted(name.encode(errors="surrogateescape") for name in file[path].attrs):
        if name != OF_ALL.encode():
            _add_attribute(digest, h5py.h5a.open(each, name), name)
    if kind == "type":
        digest.text(_text_of(each))
    elif kind == "dataset":
        digest.text(_axes(each, places))
        digest.text(_text_of(each.get_type()))
        digest.text(" ".join(map(str, each.shape)))
        _add_content(digest.sha, each, stretched)
    return digest.sha.hexdigest()


def _add_attribute(digest, attribute, name):
    kind, shape = attribute.get_type(), attribute.shape
    digest.text(name)
    digest.text(_text_of(kind))
    digest.text(" ".join(map(str, shape)))
    count = attribute.get_space().get_simple_extent_npoints()
    if isinstance(kind, h5t.TypeStringID) and kind.is_variable_str() and count == 1:
        value = np.empty(shape, dtype=object)
        attribute.read(value, kind)
        digest.text(value.reshape(-1)[0])
    elif not _points_elsewhere(kind) and count > 0:
        value = np.empty(shape, dtype=f"V{kind.get_size()}")
        attribute.read(value, kind)
        digest.sha.update(value.tobytes())


def _points_elsewhere(kind):
    return kind.detect_class(h5t.VLEN) or kind.detect_class(h5t.REFERENCE)


def _text_of(kind):
    size = kind.get_size()
    if isinstance(kind, h5t.TypeEnumID):
        names = [(kind.get_member_name(i).decode(), kind.get_member_value(i)) for i in range(kind.get_nmembers())]
        return f"enum{size}" + "".join(
            f" {name}=" + ".".join(map(str, (value % 256 ** size).to_bytes(size, "little"))) for name, value in names)
    if isinstance(kind, h5t.TypeIntegerID):
        return f"int{size} sign {int(kind.get_sign())} order {int(kind.get_order())}"
    if isinstance(kind, h5t.TypeFloatID):
        return f"float{size} order {int(kind.get_order())}"
    if isinstance(kind, h5t.TypeStringID):
        return f"text{0 if kind.is_variable_str() else size} characters {int(kind.get_cset())}"
    return f"class {int(kind.get_class())} of {size}"


def _axes(dataset, places):
    names = []
    if not h5py.h5ds.is_scale(dataset) and h5py.h5a.exists(dataset, b"DIMENSION_LIST"):
        h5py.h5ds.iterate(dataset, 0, lambda scale: names.append(places.get(h5o.get_info(scale).addr)))
    return "".join(name + "\n" for name in names if name is not None)


def _add_content(sha, dataset, stretched):
    kind, shape = dataset.get_type(), dataset.shape
    size = kind.get_size()
    if _points_elsewhere(kind) or len(shape) != 1 or size == 0 or size > AT_ONCE:
        return  # no column of the program's
    rows = STRETCH // size
    if not stretched or shape[0] <= rows:
        _add_rows(sha, dataset, 0, shape[0])
        return
    for first in range(0, shape[0], rows):
        part = hashlib.sha256()
        _add_rows(part, dataset, first, min(shape[0], first + rows))
        sha.update(part.hexdigest().encode())


def _add_rows(sha, dataset, begin, end):
    kind = dataset.get_type()
    size = kind.get_size()
    for first in range(begin, end, AT_ONCE // size):
        count = min(end - first, AT_ONCE // size)
        rows = dataset.get_space()
        rows.select_hyperslab((first,), (count,))
        part = np.empty(count, dtype=f"V{size}")
        dataset.read(h5s.create_simple((count,)), rows, part, kind)
        sha.update(part.tobytes())
