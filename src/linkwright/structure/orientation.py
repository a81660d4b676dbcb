"""Which freedoms the rows of a mechanism take: an orientation of rows towards nodes, found by a pebble game.

A node has so many freedoms (pebbles), a row ties two nodes or more and takes one freedom of one of them. A set of nodes
that hangs on nothing keeps the three motions of a rigid body, so its rows are independent in general as long as no part
of it has more of them than freedoms less three: a matroid, in which a row is tested by four pebbles gathered at its
ends. It counts only: of special dimensions it knows nothing.

Sources: D. J. Jacobs, B. Hendrickson, An algorithm for two-dimensional rigidity percolation: the pebble game, J.
Comput. Phys. 137 (1997); A. Lee, I. Streinu, Pebble game algorithms and sparse graphs, Discrete Math. 308 (2008); of
rows with more than two ends: I. Streinu, L. Theran, Sparse hypergraphs and pebble game algorithms, European J.
Combin. 30 (2009).
"""

from __future__ import annotations

from collections.abc import Collection, Hashable, Iterable, Iterator, Mapping
from itertools import chain
from typing import Generic, TypeVar

Node = TypeVar("Node", bound=Hashable)

BODY = 3
"""The freedoms of a rigid body in the plane, which rows within a set can't take."""


class Orientation(Generic[Node]):
    """Nodes with their freedoms, and the rows laid on them so far; each accepted row is held by one of its ends.

    ``rows`` are those that each node holds, each by its other ends, to which the node's arcs lead: what it hangs on. A
    row costs a few walks over all arcs.
    """

    def __init__(self, freedoms: Mapping[Node, int]) -> None:
        self.free = dict(freedoms)
        self.rows: dict[Node, list[tuple[Node, ...]]] = {node: [] for node in freedoms}

    def arcs(self, node: Node) -> Iterator[Node]:
        """What a node hangs on: the other ends of the rows that it holds."""
        return chain.from_iterable(self.rows[node])

    def lay(self, *ends: Node) -> set[Node]:
        """Lay a row between nodes. Gives nothing where it is independent of those before; else the smallest set of
        nodes that these hold rigid with all ends in it, and the row isn't laid."""
        if not self.gather(ends, BODY + 1):
            return self.reached(ends)
        holder = next(end for end in ends if self.free[end])
        self.free[holder] -= 1
        self.rows[holder].append(tuple(end for end in ends if end != holder))
        return set()

    def gather(self, ends: Collection[Node], most: int) -> bool:
        """Bring so many free pebbles to some nodes, from wherever rows can be handed over; whether they came."""
        wanting = most - sum(self.free[end] for end in ends)
        return all(any(self._draw(end, ends) for end in ends) for _ in range(wanting))

    def gather_pebbles(self, nodes: Iterable[Node]) -> None:
        """Bring free pebbles to the first of some nodes where they can be, then to the next."""
        kept: set[Node] = set()
        for node in nodes:
            kept.add(node)
            while self._draw(node, kept):
                pass

    def _draw(self, node: Node, kept: Collection[Node]) -> bool:
        """Bring one free pebble to a node, not from those ``kept``: along a path of arcs, all of them turned round."""
        before: dict[Node, Node] = {node: node}
        todo = [node]
        while todo:
            at = todo.pop()
            for end in self.arcs(at):
                if end in before:
                    continue
                before[end] = at
                if self.free[end] and end not in kept:
                    self.free[end] -= 1
                    while end != node:
                        end = self._turn(before[end], end)
                    self.free[node] += 1
                    return True
                todo.append(end)
        return False

    def _turn(self, holder: Node, other: Node) -> Node:
        """Hand a row over to another of its ends."""
        row = next(row for row in self.rows[holder] if other in row)
        self.rows[holder].remove(row)
        self.rows[other].append(tuple(end for end in (holder, *row) if end != other))
        return holder

    def reached(self, nodes: Iterable[Node]) -> set[Node]:
        """All that some nodes hang on, they themselves included."""
        found = set(nodes)
        todo = list(found)
        while todo:
            fresh = [end for end in self.arcs(todo.pop()) if end not in found]
            found.update(fresh)
            todo += fresh
        return found

    def hanging(self, nodes: Iterable[Node]) -> set[Node]:
        """All that hangs on some nodes, they themselves included."""
        holders: dict[Node, list[Node]] = {node: [] for node in self.rows}
        for holder in self.rows:
            for end in self.arcs(holder):
                holders[end].append(holder)
        found = set(nodes)
        todo = list(found)
        while todo:
            fresh = [holder for holder in holders[todo.pop()] if holder not in found]
            found.update(fresh)
            todo += fresh
        return found
