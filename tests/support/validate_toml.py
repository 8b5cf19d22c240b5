"""validate_toml.py SCHEMA.json FILE.toml ...: names every file that is none of the schema's, with the first place.

Ends with 0 whatever it found; it is the tests that know what to expect."""

import json
import sys
import tomllib

import jsonschema

with open(sys.argv[1], encoding="utf-8") as file:
    schema = json.load(file)
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for name in sys.argv[2:]:
    with open(name, "rb") as file:
        document = tomllib.load(file)
    for error in validator.iter_errors(document):
        print(f"{name}: {error.json_path}: {error.message[:200]}")
        break
