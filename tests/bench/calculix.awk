# Input for CalculiX: quadratic (CPS8) or linear (CPS4) quadrilaterals. awk -v case=cantilever|hole -v n=<elements across> -v order=1|2
# Cantilever of the paper, a column ending at the load; a quarter of the plate with a hole, under the tractions of Kirsch's stress.
function node(i, j) { return i * (2 * rows + 1) + j + 1 }
function put(i, j, x, y) { if (order == 2 ? !(i % 2 && j % 2) : !(i % 2 || j % 2)) printf "%d, %.12g, %.12g\n", node(i, j), x, y; X[i, j] = x; Y[i, j] = y }
function elements(   i, j) {
  printf "*ELEMENT, TYPE=%s, ELSET=E\n", order == 2 ? "CPS8" : "CPS4"
  for (i = 0; i < 2 * columns; i += 2) for (j = 0; j < 2 * rows; j += 2) {
    printf "%d, %d, %d, %d, %d", ++count, node(i, j), node(i + 2, j), node(i + 2, j + 2), node(i, j + 2)
    if (order == 2) printf ", %d, %d, %d, %d", node(i + 1, j), node(i + 2, j + 1), node(i + 1, j + 2), node(i, j + 1)
    print ""
  }
}
function material(e, nu) {
  printf "*MATERIAL, NAME=M\n*ELASTIC\n%g, %g\n*SOLID SECTION, ELSET=E, MATERIAL=M\n%g\n", e, nu, thickness
}
function finish(id, dof) {
  printf "*NSET, NSET=SEEN\n%d\n*STEP\n*STATIC\n", id
  if (case == "cantilever") printf "*CLOAD\n%d, 2, %g\n", node(2 * columns - 2, 2 * rows), -5000 * thickness
  else { print "*CLOAD"; for (k in F) { split(k, p, SUBSEP); printf "%d, %d, %.12g\n", p[1], p[2], F[k] * thickness } }
  print "*NODE PRINT, NSET=SEEN\nU\n*END STEP"
}
function kirsch(x, y,   q, t) {
  q = 1 / (x * x + y * y); t = atan2(y, x)
  sx = 1e6 * (1 - q * (1.5 * cos(2 * t) + cos(4 * t)) + 1.5 * q * q * cos(4 * t))
  sy = 1e6 * (-q * (0.5 * cos(2 * t) - cos(4 * t)) - 1.5 * q * q * cos(4 * t))
  sxy = 1e6 * (-q * (0.5 * sin(2 * t) + sin(4 * t)) + 1.5 * q * q * sin(4 * t))
}
# Consistent loads of the edge of an element along i = last, from j on: its normal is to the right of the way.
function load_edge(i, j,   k, s, w, x, y, dx, dy, shape, m) {
  dx = X[i, j + 2] - X[i, j]; dy = Y[i, j + 2] - Y[i, j]
  for (k = -1; k <= 1; ++k) {
    s = k * 0.7745966692414834; w = (k == 0 ? 8 : 5) / 18
    kirsch(X[i, j] + (s + 1) / 2 * dx, Y[i, j] + (s + 1) / 2 * dy)
    for (m = 0; m <= 2; m += order == 2 ? 1 : 2) {
      shape = order == 1 ? (m ? (1 + s) / 2 : (1 - s) / 2) : m == 0 ? s * (s - 1) / 2 : m == 1 ? 1 - s * s : s * (s + 1) / 2
      F[node(i, j + m), 1] += w * shape * (sx * dy - sxy * dx); F[node(i, j + m), 2] += w * shape * (sxy * dy - sy * dx)
    }
  }
}
BEGIN {
  # CalculiX makes solids of plane elements: thin, so that no shear comes into them where their thickness changes along them.
  thickness = 0.01
  print "*NODE, NSET=ALL"
  if (case == "cantilever") {
    rows = n; columns = 8 * n + 1
    for (i = 0; i <= 2 * columns; ++i) for (j = 0; j <= 2 * rows; ++j)
      put(i, j, i <= 16 * n ? 7.9 * i / (16 * n) : 7.9 + (i - 16 * n) * 0.05, j / (2 * rows))
    elements(); material(35e9, 0.3); print "*BOUNDARY"
    for (j = 0; j <= 2 * rows; j += order == 2 ? 1 : 2) printf "%d, 1, 2\n", node(0, j)
    finish(node(2 * columns - 2, rows))
  } else {
    rows = 2 * n; columns = 2 * n; pi = atan2(0, -1)
    for (i = 0; i <= 2 * columns; ++i) for (j = 0; j <= 2 * rows; ++j) {
      t = pi / 2 * j / (2 * rows); s = i / (2 * columns); s = s * (1 + 2 * s) / 3
      ox = j <= rows ? 4 : 4 * (2 * rows - j) / rows; oy = j <= rows ? 4 * j / rows : 4
      put(i, j, (1 - s) * cos(t) + s * ox, (1 - s) * sin(t) + s * oy)
    }
    elements(); material(10e9, 0.25); print "*BOUNDARY"
    for (i = 0; i <= 2 * columns; i += order == 2 ? 1 : 2) { printf "%d, 2\n%d, 1\n", node(i, 0), node(i, 2 * rows) }
    for (j = 0; j < 2 * rows; j += 2) load_edge(2 * columns, j)
    finish(node(0, 0))
  }
}
