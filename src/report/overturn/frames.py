"""Tables as pandas and xarray objects."""

from .errors import Error, require
from .results import ROW, name_since


def chosen(columns, names):
    """All of them, or those named, in that order."""
    if names is None:
        return columns
    names = [name_since(name) for name in names]
    unknown = [name for name in names if name not in columns]
    if unknown:
        raise Error(f"no column {', '.join(unknown)} among the rows. There are: {', '.join(columns)}")
    return {name: columns[name] for name in names}


def frame_of(table, names=None):
    require("pandas", what="tables are made with it")
    import pandas
    columns = chosen(table.rows, names)
    frame = pandas.DataFrame({name: pandas.Categorical.from_codes(column.codes, column.categories) if column.categories
                              else column.values for name, column in columns.items()})
    frame.attrs = {**table.attrs, "units": {name: column.units for name, column in columns.items()},
                   "meanings": {name: column.meaning for name, column in columns.items()}}
    return frame


def frame_of_bodies(tables, names=None):
    require("pandas", what="tables are made with it")
    import pandas
    frames = {body: frame_of(table, names) for body, table in tables.items()}
    whole = pandas.concat([frame.drop(columns="body", errors="ignore") for frame in frames.values()], ignore_index=True)
    whose = [place for place, frame in enumerate(frames.values()) for _ in range(len(frame))]
    whole.insert(0, "body", pandas.Categorical.from_codes(whose, list(frames)))
    for name in whole.columns:  # of names that only some bodies have
        if whole[name].dtype == object:
            whole[name] = whole[name].astype("category")
    whole.attrs = shared([frame.attrs for frame in frames.values()])
    whole.attrs["units"] = {"body": "1", **agreed([frame.attrs["units"] for frame in frames.values()])}
    whole.attrs["meanings"] = {"body": "name of the body", **agreed([frame.attrs["meanings"] for frame in frames.values()])}
    return whole


def shared(attributes):
    """What all of them have in common."""
    return {key: value for key, value in attributes[0].items() if all(other.get(key) == value for other in attributes)}


def agreed(attributes):
    """One entry a column; "" where bodies differ: then a column of the table says it, as `units_from` of the file."""
    names = dict.fromkeys(name for each in attributes for name in each if name != "body")
    return {name: found.pop() if len(found) == 1 else "" for name in names
            for found in [{each[name] for each in attributes if name in each}]}


def dataset_of(table, names=None):
    require("xarray", what="datasets are made with it")
    import xarray
    columns = chosen(dict(table), names)
    axes = {axis for column in columns.values() for axis in column.axes}
    variables = {}
    for name, column in {**columns, **{axis: table[axis] for axis in axes if axis in table}}.items():
        attributes = {key: value for key, value in column.attrs.items() if key not in ("flag_values", "flag_meanings")}
        if column.categories:
            attributes["categories"] = list(column.categories)
        variables[name] = (column.axes, column.names if column.categories else column.values, attributes)
    coordinates = {name: variables.pop(name) for name in list(variables) if name in axes}
    if ROW in axes and ROW not in table:
        coordinates[ROW] = (ROW, range(len(next(iter(columns.values())))), {"units": "1", "long_name": "number of the row"})
    return xarray.Dataset(variables, coordinates, table.attrs)


def dataset_of_bodies(tables, names=None):
    require("xarray", what="datasets are made with it")
    import pandas
    import xarray
    each = []
    for table in tables.values():
        data = dataset_of(table, names)
        each.append(data.isel(body=0, drop=True) if "body" in data.dims else data)
    whole = xarray.concat(each, pandas.Index(list(tables), name="body"), join="outer", combine_attrs="drop_conflicts")
    whole["body"].attrs["long_name"] = "name of the body"
    return whole
