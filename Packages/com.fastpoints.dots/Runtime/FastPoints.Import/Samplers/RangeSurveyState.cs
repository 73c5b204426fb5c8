using Unity.Mathematics;

namespace FastPoints.Samplers
{
    /// <summary>Makes a <see cref="RangeSurvey"/> of points of which nodes above may have taken any: in slices, since a chunk's
    /// first range has all of its points. Blittable.</summary>
    internal unsafe struct RangeSurveyState
    {
        public SampledRange Range;

        /// <summary>Complete when <see cref="GoOn"/> returns true.</summary>
        public RangeSurvey Look;
        int m_at;
        int m_taken;

        // log2 of the largest cube that neighbours have in common since the last taken point.
        uint m_sinceTaken;

        public RangeSurveyState(in SampledRange range)
        {
            Range = range;
            Look = default;
            m_at = range.First;
            m_taken = 0;
            m_sinceTaken = 0;
        }

        /// <param name="common">For each point, log2 of the side of the smallest cube with it and the previous point.</param>
        /// <param name="nodeOfPoint">Negative for points that are in no node yet.</param>
        /// <param name="budget">The number of points that may still be visited.</param>
        /// <returns>Whether all points were visited.</returns>
        public bool GoOn(byte* common, int* nodeOfPoint, ref long budget)
        {
            var look = Look;
            int end = (int)math.min(Range.End, m_at + budget), taken = m_taken;
            uint sinceTaken = m_sinceTaken, largest = (uint)look.Largest;
            // For each side, this counts neighbours in the order whose smallest common cube has it: over all points, minus the
            // taken ones. A cell boundary lies between two points if their common cube is larger than the cell.
            for (int i = m_at; i < end; i++)
            {
                if (i > Range.First)
                {
                    look.CellsBelow[common[i]]++;
                    sinceTaken = math.max(sinceTaken, common[i]);
                    largest = math.max(largest, common[i]);
                }
                if (nodeOfPoint[i] < 0)
                    continue;
                if (taken++ > 0)
                    look.CellsBelow[sinceTaken]--;
                sinceTaken = 0;
            }
            look.Largest = (int)largest;
            look.Left = end - Range.First - taken;
            look.AnyCell = taken > 0 ? 0 : 1;
            budget -= end - m_at;
            m_at = end;
            m_taken = taken;
            m_sinceTaken = sinceTaken;
            Look = look;
            return end == Range.End;
        }
    }
}
