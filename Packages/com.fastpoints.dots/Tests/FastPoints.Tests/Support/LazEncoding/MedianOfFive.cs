namespace FastPoints.Tests
{
    /// <summary>What <see cref="FastPoints.Laz.Median5"/> computes, in plain steps: sorted values, of which the largest or the
    /// smallest leaves for the new one.</summary>
    public sealed class MedianOfFive
    {
        readonly System.Collections.Generic.List<int> m_values = new System.Collections.Generic.List<int> { 0, 0, 0, 0, 0 };
        bool m_dropsLargest = true;

        public int Value => m_values[2];

        public void Add(int value)
        {
            int middle = Value;
            m_values.RemoveAt(m_dropsLargest ? 4 : 0);
            m_values.Add(value);
            m_values.Sort();
            m_dropsLargest = m_dropsLargest ? value < middle : value <= middle;
        }
    }
}
