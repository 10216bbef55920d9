"""The link monitor (section 8.3 of the text)."""

from collections import OrderedDict, namedtuple
from math import isfinite

from .fields import MAX_INTEGER

MAX_UPDATES = 256
"""The most updates of the detector that one gap makes [NCP-RES-047]."""

MAX_MISSING = 4096
"""The most missing seqs that are remembered; the lowest are forgotten first [NCP-RES-048] [NCP-RES-056] [NCP-RES-057]."""

LinkState = namedtuple("LinkState", "last_seq received lost loss_rate burst")
"""What the monitor knows; the names are those of `LinkStatus`."""


class LinkMonitor:
    """Counts what a stream loses, and raises a burst when losses bunch up."""

    def __init__(self, ref_loss=0.05, threshold=5.0):
        self._ref_loss = min(max(ref_loss, 0.0), 0.99) if isfinite(ref_loss) else 0.05  # [NCP-RES-051]
        self._threshold = threshold if isfinite(threshold) and threshold > 0 else 5.0  # [NCP-RES-052]
        self._first = None
        self._expected = None
        self._missing = OrderedDict()
        self._received = 0
        self._lost = 0
        self._cusum = 0.0

    def on_frame(self, seq):
        """A frame with this seq arrived."""
        if self._first is None:
            self._first = self._expected = seq
        if seq < self._expected and seq not in self._missing:
            return  # [NCP-RES-042] a duplicate
        if seq < self._expected:
            del self._missing[seq]  # [NCP-RES-041] late
            self._lost -= 1
        else:
            self._miss(seq - self._expected, seq)
            self._expected = seq + 1  # [NCP-RES-043]
        self._received += 1
        self._update(-self._ref_loss)

    def state(self):
        """The state now."""
        slots = 0 if self._first is None else self._expected - self._first
        return LinkState(
            last_seq=-1 if self._first is None else self._expected - 1,
            received=min(self._received, MAX_INTEGER),
            lost=min(self._lost, MAX_INTEGER),  # [NCP-RES-050]
            loss_rate=self._lost / slots if slots else 0.0,  # [NCP-RES-044] [NCP-RES-045]
            burst=self._cusum > self._threshold,  # [NCP-RES-046]
        )

    def _miss(self, count, seq):
        """The `count` seqs before `seq` did not come [NCP-RES-040]."""
        self._lost += count
        for _ in range(min(count, MAX_UPDATES)):
            self._update(1.0 - self._ref_loss)
        for missing in range(seq - min(count, MAX_MISSING), seq):
            self._missing[missing] = None
        while len(self._missing) > MAX_MISSING:
            self._missing.popitem(last=False)

    def _update(self, step):
        # [NCP-RES-049]
        self._cusum = min(max(self._cusum + step, 0.0), 2.0 * self._threshold)
