# Links to a scene.
link-problem = link, character { $position }: { $words }
link-line = line { $line } of its scene: { $words }
link-did-you-mean = {" "}(did you mean { $name }?)
link-unknown-key = is not a key of a link, expected one of { $keys }{ $meant }
link-twice = stands twice, expected once
link-not-encoded = has a % without two hexadecimal digits, or bytes that are not UTF-8, expected %25 for a percent sign
link-expected-scene = the name of a built-in scene{ $meant }
link-expected-probe = two numbers x,y, from the picture's middle in units of its shorter side
link-expected-line = four numbers x0,y0,x1,y1, from the picture's middle in units of its shorter side
link-expected-controls = at most { $most } words of a-z, 0-9, dots and hyphens between commas
link-many-panes = stands too often, expected at most five panes
link-too-long = is longer than { $limit } KiB, expected a link
link-query-too-long = has more than { $limit } KiB between ? and #, expected fewer settings
link-unknown-fragment = is not known, expected #scene= and a packed scene
link-beside-file = stands beside a whole scene after #, expected one or the other
link-not-base64 = is not base64url, expected a scene packed by shading-lab
link-not-packed = cannot be unpacked, expected a scene packed by shading-lab; the link may have been cut
link-unpacks-to-more = unpacks to more than { $limit } KiB, expected a scene
link-no-file = is asked for, expected no model: a link cannot carry or open a file
link-scene-too-large = the scene is longer than { $limit } KiB and does not fit into a link, expected fewer polygons; send its file instead
link-no-page = expected the address of a page, as in https://example.org/shading-lab/
link-model-stays = the model { $path } is a file and does not travel with the link; whoever opens it sees the teapot instead
