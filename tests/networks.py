"""networks.py - an oracle for networks written as text, which shares no code with mlg

    networks.py count kkcb         how many different stiffnesses the networks of these elements
                                   have, any graph, and how many a path of springs, k
    networks.py least              for each line TEXT,k_s,b,c_d[,F_z[,V...]] of standard input:
                                   the least damping ratio over these V, m/s, or over 400 of
                                   them from 0.3 to 200 m/s
    networks.py inside             for each line TEXT,k_s,b,c_d,NAME,p of standard input: the least damping ratio
                                   over 60 V at 40 corners, drawn at random, of the box in which all that
                                   docs/design.md names, and the element NAME=VALUE, lie within +-p per cent
    networks.py balance            for each line TEXT,k_s: the static stiffness; for TEXT,k_s,b,c_d the absolute
                                   value of the dynamic one at s = 3 + 70i
    networks.py corner             for each line TEXT,k_s,b,c_d,p,CORNER,V...: the least damping ratio with each
                                   NAME+ or NAME- of CORNER a part p above or below its value
    networks.py passive            for each line NUM,DEN,F_z,K (coefficients, powers of s rising):
                                   the same, where NUM/DEN is passive and has a static stiffness of
                                   at least K, else why not

A network is a graph: elements between nodes, node 0 the strut, node 1 behind k_psi.  Its
stiffness comes from the balance of torques at the nodes, not from polynomials; the gear's
matrices are the closed form of straight rolling, docs/model.md.  With psi, delta and lambda
the twists of the nodes make one pencil A x = s E x."""
import itertools
import random
import re
import sys

import numpy as np

GEAR = dict(k_psi=3.8e5, k_d=1.09e5, c_psi=300., k_delta=6.1e6, c_delta=300., a=.5, e=.12, l_delta=.75, l_D=.72,
            m_D=500., J_xi=200., J_zeta=100., phi=np.pi / 60, h=.1, k_t=7e5, k_alpha=1., k_lambda=.002, l=.3,
            R=.362, g=9.81)


def graph(text):
    """The elements (kind, name or value, node, node) between node 1 and node 0."""
    tokens = re.findall(r"[A-Za-z]\w*(?:=[0-9.eE+]+(?:(?<=[eE])-[0-9]+)?)?|[|()-]", text)
    nodes = itertools.count(2)
    elements = []

    def group(top, bottom):
        branch(top, bottom)
        while tokens and tokens[0] == "|":
            tokens.pop(0)
            branch(top, bottom)

    def branch(top, bottom):
        # the number of elements in series is known only behind them: a node each, the last moved
        here = top
        first = len(elements)
        while True:
            after = next(nodes)
            token = tokens.pop(0)
            if token == "(":
                group(here, after)
                assert tokens.pop(0) == ")", text
            else:
                name, _, value = token.partition("=")
                elements.append((name[0], float(value) if value else name, here, after))
            if not tokens or tokens[0] != "-":
                break
            tokens.pop(0)
            here = after
        elements[first:] = [(k, v, bottom if p == after else p, bottom if q == after else q)
                            for k, v, p, q in elements[first:]]

    group(1, 0)
    assert not tokens, text
    return elements


def pencil(text, k_s, b, c_d, V, F_z=200e3, **other):
    """A, E of A x = s E x, x = delta, psi, lambda, the nodes, and the rates of all but lambda."""
    p = {**GEAR, "k_s": k_s, "b": b, "c_d": c_d, **other}
    s, c = np.sin(p["phi"]), np.cos(p["phi"])
    et, L = p["e"] + p["R"] * s, p["l_delta"] + p["R"] * c
    m, kap = p["a"]**2 * p["m_D"] / 4, p["a"]**2 * p["k_t"] / 2
    elements = graph(text) + [("k", "k_psi", -1, 1)]
    names = {node: 2 + i for i, node in enumerate(sorted({n for e in elements for n in e[2:] if n > 0}))}
    names[-1] = 1  # psi
    n = 2 + len(names) - 1
    K, C, M = np.zeros((n, n)), np.zeros((n, n)), np.zeros((n, n))
    for kind, value, at, to in elements:
        matrix = {"k": K, "c": C, "b": M}[kind]
        value = p[value] if isinstance(value, str) else value
        for x, y in ((at, to), (to, at)):
            if x != 0:
                matrix[names[x], names[x]] += value
                if y != 0:
                    matrix[names[x], names[y]] -= value
    K[0, 0] += p["k_delta"] - F_z * L * c + kap * c * c + p["m_D"] * p["g"] * p["l_D"] * c
    K[0, 1] += -F_z * et * c + kap * c * s
    K[1, 0] += -F_z * et * c + kap * c * s
    K[1, 1] += -F_z * et * s + kap * s * s
    C[0, 0] += p["c_delta"]
    C[1, 1] += p["c_psi"]
    M[0, 0] += p["J_xi"] + p["m_D"] * p["l_D"]**2 + m * c * c
    M[0, 1] += m * c * s
    M[1, 0] += m * c * s
    M[1, 1] += p["J_zeta"] + m * s * s
    D = np.zeros(n)
    D[0] = F_z * (7 * p["k_lambda"] * L - p["k_alpha"] * s) / p["l"]
    D[1] = F_z * (7 * p["k_lambda"] * et + p["k_alpha"] * c) / p["l"]
    A, E = np.zeros((2 * n + 1, 2 * n + 1)), np.eye(2 * n + 1)
    A[:n, n:2 * n] = np.eye(n)
    A[n:2 * n, :n], A[n:2 * n, n:2 * n], A[n:2 * n, 2 * n] = -K, -C, -D
    E[n:2 * n, n:2 * n] = M
    A[2 * n, n], A[2 * n, 1], A[2 * n, n + 1], A[2 * n, 2 * n] = L, V * c, et - p["h"] * c, -V / p["l"]
    scale = np.concatenate([np.ones(n), np.full(n, 80.), [1.]])  # rates in units of 80 rad/s
    rows = np.concatenate([np.full(n, 1 / 80.), np.full(n, 1e-6), [1 / 80.]])
    return rows[:, None] * A * scale, rows[:, None] * E * scale


def eigenvalues(*args, **kwargs):
    A, E = pencil(*args, **kwargs)
    shift = 7.
    mu = np.linalg.eigvals(np.linalg.solve(A - shift * E, E))
    s = shift + 1 / mu[abs(mu) > 1e-7]  # those at 0, but for rounding, belong to nodes without inertia: s at infinity
    return s[abs(s) > 1e-4]  # and those at 0 to nodes that no spring holds


def damping(eigenvalue):
    x = eigenvalue[(eigenvalue.imag != 0) | (eigenvalue.real > 0)]
    return min(1., *(np.where(x.imag != 0, -x.real / abs(x), -1.))) if len(x) else 1.


def least(line):
    text, k_s, b, c_d, *rest = line.split(",")
    F_z, *V = [float(x) for x in rest] or [200e3]
    speeds = V or np.geomspace(.3, 200., 400)
    return min(damping(eigenvalues(text, float(k_s), float(b), float(c_d), v, F_z)) for v in speeds)


def balance(line):
    """Torque over twist at s = 0, or of size at s = 3 + 70i where b and c_d are given."""
    text, k_s, *rest = line.split(",")
    b, c_d = [float(x) for x in rest] or (0., 0.)
    s = 3 + 70j if rest else 0.
    p = dict(GEAR, k_s=float(k_s), b=b, c_d=c_d)
    elements = graph(text)
    nodes = sorted({n for e in elements for n in e[2:]})  # 0 and 1 first
    Z = np.zeros((len(nodes), len(nodes)), complex)
    for kind, value, at, to in elements:
        x = np.zeros(len(nodes))
        x[nodes.index(at)], x[nodes.index(to)] = 1., -1.
        Z += (p[value] if isinstance(value, str) else value) * s**"kcb".index(kind) * np.outer(x, x)
    torque = np.zeros(len(nodes))
    torque[:2] = -1., 1.
    twist = np.linalg.lstsq(Z, torque, rcond=1e-15)[0]
    return abs(1. / (twist[1] - twist[0]))


BOX = "k_t e l h k_lambda k_alpha c_delta c_psi k_delta k_psi".split()


def inside(line, corners=40, seed=3):
    text, k_s, b, c_d, name, p = line.split(",")
    rng = random.Random(seed)
    worst = 1.
    for _ in range(corners):
        def side():
            return 1 + rng.choice((-1, 1)) * float(p) / 100
        moved = {parameter: GEAR[parameter] * side() for parameter in BOX}
        at = re.sub(name + r"=([0-9.eE+]+)", lambda m: "%s=%.12g" % (name, float(m[1]) * side()), text) if name else text
        device = [float(x) * side() for x in (k_s, b, c_d)]
        F_z = 200e3 * side()
        worst = min([worst] + [damping(eigenvalues(at, *device, V, F_z, **moved)) for V in np.geomspace(.3, 200., 60)])
    return worst


def least_at_corner(line):
    text, k_s, b, c_d, part, corner, *V = line.split(",")
    p = dict(GEAR, k_s=float(k_s), b=float(b), c_d=float(c_d), F_z=200e3)
    for word in corner.split():
        p[word[:-1]] *= 1 + float(part) * (1 if word[-1] == "+" else -1)
    device = [p.pop(name) for name in ("k_s", "b", "c_d")]
    F_z = p.pop("F_z")
    return min(damping(eigenvalues(text, *device, v, F_z, **p)) for v in [float(v) for v in V] or np.geomspace(.3, 200., 400))


def gear(F_z):
    """The matrix of delta, psi and lambda at V = 0 and what V adds to it, as polynomials in s."""
    p = GEAR
    s, c = np.sin(p["phi"]), np.cos(p["phi"])
    et, L = p["e"] + p["R"] * s, p["l_delta"] + p["R"] * c
    m, kap = p["a"]**2 * p["m_D"] / 4, p["a"]**2 * p["k_t"] / 2
    A11 = [p["k_delta"] - F_z * L * c + kap * c * c + p["m_D"] * p["g"] * p["l_D"] * c, p["c_delta"],
           p["J_xi"] + p["m_D"] * p["l_D"]**2 + m * c * c]
    A12 = [-F_z * et * c + kap * c * s, 0., m * c * s]
    A22 = [-F_z * et * s + kap * s * s, p["c_psi"], p["J_zeta"] + m * s * s]
    D1 = F_z * (7 * p["k_lambda"] * L - p["k_alpha"] * s) / p["l"]
    D2 = F_z * (7 * p["k_lambda"] * et + p["k_alpha"] * c) / p["l"]
    P = np.polynomial.Polynomial
    return P(A11), P(A12), P(A22), P([0., L]), lambda V: P([V * c, et - p["h"] * c]), lambda V: P([V / p["l"], 1.]), D1, D2


def passive(line):
    num, den, F_z, least_static, *V_least = line.split(",")
    P = np.polynomial.Polynomial
    num, den = (P([float(x) for x in text.split()]) for text in (num, den))
    s = 1j * np.geomspace(1e-2, 1e6, 4000)
    impedance = num(s) / den(s) / s
    if (impedance.real < -1e-9 * abs(impedance)).any():
        return "active"
    if len(den.trim().coef) > 1 and (den.roots().real > 0).any():
        return "unstable"
    if num(0.) / den(0.) < float(least_static) * (1 - 1e-9):
        return "soft"
    A11, A12, A22, Ls, q, tyre, D1, D2 = gear(float(F_z))
    whole_num, whole_den = num * GEAR["k_psi"], num + den * GEAR["k_psi"]  # with k_psi
    worst = 1.
    for V in np.geomspace(float(V_least[0]) if V_least else .3, 200., 400):
        t, p = tyre(V), q(V)
        free = A11 * (A22 * t + p * D2) - A12 * (A12 * t + Ls * D2) + (A22 * Ls - A12 * p) * D1
        F = (whole_den * free + whole_num * (A11 * t + Ls * D1)).coef
        scale = 100.**np.arange(len(F))  # s in units of 100/s
        worst = min(worst, damping(np.polynomial.polynomial.polyroots(F * scale / abs(F * scale).max())))
    return "%.8g" % worst


PRIME = (1 << 61) - 1


def stiffness(edges, value):
    """Of node 1 against node 0, modulo PRIME; None: not connected, or some node is free."""
    used = sorted({n for e in edges for n in e if n > 1})
    place = {node: i for i, node in enumerate([1] + used)}
    n = len(place)
    matrix = [[0] * n for _ in range(n)]
    for edge, y in zip(edges, value):
        for at, to in (edge, edge[::-1]):
            if at in place:
                matrix[place[at]][place[at]] += y
                if to in place:
                    matrix[place[at]][place[to]] -= y
    for i in range(n - 1, 0, -1):  # the free nodes one after the other, so that node 1 is left
        pivot = next((r for r in range(i, 0, -1) if matrix[r][i] % PRIME), None)
        if pivot is None:
            return None
        matrix[i], matrix[pivot] = matrix[pivot], matrix[i]
        inverse = pow(matrix[i][i], -1, PRIME)
        for r in range(i):
            factor = matrix[r][i] * inverse % PRIME
            matrix[r] = [(a - factor * b) % PRIME for a, b in zip(matrix[r], matrix[i])]
    return matrix[0][0] % PRIME


def joined(edges):
    """Whether these edges alone lead from node 1 to node 0."""
    reached = {1}
    for _ in edges:
        for p, q in edges:
            if p in reached or q in reached:
                reached |= {p, q}
    return 0 in reached


def graphs(n, edges=(), top=1):
    """All graphs of n edges between nodes 0, 1, ..., those beyond 1 numbered as they come and none of them loose."""
    if len(edges) == n:
        ends = [node for edge in edges for node in edge]
        if all(ends.count(node) > 1 for node in range(2, top + 1)):
            yield edges
        return
    for q in range(1, top + 3):
        for p in range(0, min(q, top + 2)):
            if q <= max(top, p) + 1:
                yield from graphs(n, edges + ((p, q),), max(top, p, q))


def distinct(letters, seed=1):
    """Values of the edges, and of each stiffness in which every edge matters the graph."""
    rng = random.Random(seed)
    value, other = ([rng.randrange(1, PRIME) for _ in letters] for _ in range(2))
    found = {}
    for edges in graphs(len(letters)):
        z = stiffness(edges, value)
        if not z or z in found:
            continue
        moved = (value[:i] + [other[i]] + value[i + 1:] for i in range(len(letters)))
        if all(stiffness(edges, m) not in (None, z) for m in moved):
            found[z] = edges
    return value, found


def springs_join(edges, letters):
    return joined([e for e, letter in zip(edges, letters) if letter in "kK"])


def count(letters):
    """Stiffnesses of graphs with an edge for each letter, in which every edge matters, and of
    those in which the springs, k, lead from end to end."""
    found = distinct(letters)[1]
    return len(found), sum(springs_join(edges, letters) for edges in found.values())


def is_bridge(edges):
    """Of five edges, whether they are Wheatstone's: four nodes, all of three ends but the two terminals."""
    ends = sorted(node for edge in edges for node in edge)
    return len(edges) == 5 and sorted(ends.count(n) for n in set(ends)) == [2, 2, 3, 3] and ends.count(0) == ends.count(1) == 2 \
        and len(set(edges)) == 5 and (0, 1) not in edges


def count_larger(letters):
    """The series-parallel ones with two like elements, CC or KK (k is k_d), that a path of springs joins, of
    which no single element in place of the two does as well; of KK one of each two that differ by the exchange
    of these; and the bridges."""
    value, found = distinct(letters)
    i, j = [k for k, letter in enumerate(letters) if letter in "KC"]
    kept, bridges = set(), 0
    t = random.Random(2).randrange(1, PRIME)
    side = value[:]  # what two side by side do not notice
    side[i], side[j] = (value[i] + t) % PRIME, (value[j] - t) % PRIME
    line = value[:]  # and what two one behind the other do not
    inverse = [pow(v, -1, PRIME) for v in value]
    line[i], line[j] = pow(inverse[i] + t, -1, PRIME), pow(inverse[j] - t, -1, PRIME)
    swapped = value[:]
    swapped[i], swapped[j] = value[j], value[i]
    for z, edges in found.items():
        if is_bridge(edges):
            bridges += 1
        elif springs_join(edges, letters) and z not in (stiffness(edges, side), stiffness(edges, line)):
            kept.add(min(z, stiffness(edges, swapped)) if letters[i] == "K" else z)
    return len(found), len(kept), bridges


def main():
    if sys.argv[1] == "count":
        print(*(count_larger if set(sys.argv[2]) & set("KC") else count)(sys.argv[2]))
    else:
        of_line = {"least": least, "corner": least_at_corner, "inside": inside, "balance": balance, "passive": passive}[sys.argv[1]]
        for line in sys.stdin:
            answer = of_line(line.strip())
            print(answer if isinstance(answer, str) else "%.10g" % answer)


if __name__ == "__main__":
    main()
