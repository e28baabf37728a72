//! A lesson with every kind of question, small enough to be solved often.

/// A lesson with the kinds in the order of `docs/lessons.md`, some of them twice.
pub const EVERY_KIND: &str = r#"+++
lesson = 1
name = "every-kind"
title = "Every kind"
topic = "light"
minutes = 7
about = "For tests."
+++

## Choice

Number {{ scene.material.n | 1 }} and `$K_d$`.

```step
scene = "sphere"
set = ["camera.eye=[0,0,4]", "image.size=[96,96]", "material.n=20"]
view = "equation"
probe = [0.1, 0.1]
line = [-0.3, 0.0, 0.3, 0.0]
overlays = ["vectors"]
controls = ["n"]
hide = true
```

```question
kind = "choice"
ask = "Choice"
why = "Because {{ 1 + 1 | 0 }}."
term = "specular"
[[option]]
text = "Yes"
holds = "1 < 2"
[[option]]
text = "No"
holds = "1 > 2"
```

## Choice by scenes

```question
kind = "choice"
ask = "Which is brighter?"
greatest = "probe.sum[0]"
[[option]]
text = "Dark"
set = ["material.kd=0.1"]
[[option]]
text = "Light"
set = ["material.kd=0.9"]
```

## Value

```question
kind = "value"
ask = "Value"
answer = "cos(60)"
tolerance = 0.02
from = -1
to = 1
unit = "m"
```

## Point

```question
kind = "point"
ask = "Point"
find = "least"
of = "probe.position[0]^2 + probe.position[1]^2"
tolerance = 0.06
```

## Zero

```question
kind = "point"
ask = "Zero"
find = "zero"
of = "probe.position[0]"
tolerance = 0.04
```

## Curve

```question
kind = "curve"
ask = "Curve"
x = [0, 90]
y = [0, 1]
x_name = "φ"
y_name = "share"
answer = "cos(x)"
```

## Profile

```question
kind = "curve"
ask = "Profile"
y = [0, 2]
tolerance = 0.02
profile = "phong"
```

## Settings

```question
kind = "settings"
ask = "Settings"
control = "material.n"
reach = "scene.material.n"
equals = "30"
tolerance = 1
```

## Most

```question
kind = "settings"
ask = "Most"
control = "material.kd"
reach = "0 - (scene.material.kd - 0.5)^2"
most = true
tolerance = 0.05
```

## Order

```question
kind = "order"
ask = "Order"
by = "scene.material.n"
[[item]]
text = "C"
set = ["material.n=50"]
[[item]]
text = "A"
set = ["material.n=5"]
[[item]]
text = "B"
set = ["material.n=15"]
```

## Match

```question
kind = "match"
ask = "Match"
set = ["material.kd=0.2"]
controls = ["material.kd"]
```

## Match at random

```question
kind = "match"
ask = "Match"
controls = ["material.kd", "material.ks"]
```
"#;
