using System.Collections.Generic;
using System.Globalization;
using FastPoints.Streaming;

namespace FastPoints.Editor
{
    /// <summary>What the last frame of a world did, in words: of all its clouds together.</summary>
    public static class FrameText
    {
        /// <summary>Pairs of a name and a value.</summary>
        public static List<KeyValuePair<string, string>> Describe(in FrameStats stats, long budgetPoints, long limitBytes)
        {
            return new List<KeyValuePair<string, string>>
            {
                Pair("Points", "{0:N0} drawn of {1:N0} selected, {2:N0} at most", stats.DrawnPoints, stats.SelectedPoints,
                    budgetPoints),
                Pair("Nodes", "{0:N0} drawn, {1:N0} in memory", stats.DrawnNodes, stats.CachedNodes),
                Pair("Graphics memory", "{0:0.0} of {1:0} MiB", stats.PoolBytes / 1048576.0, limitBytes / 1048576.0),
                Pair("Hierarchy", "{0:0.0} MiB", stats.HierarchyBytes / 1048576.0),
                Pair("Reads", stats.IsSettled ? "nothing is missing" : "{0} under way, {1:0.0} MiB in this frame",
                    stats.ReadsUnderWay, stats.ReadBytes / 1048576.0),
                Pair("Main thread", "{0:0.00} ms", stats.TotalMs),
            };
        }

        static KeyValuePair<string, string> Pair(string name, string format, params object[] values) =>
            new KeyValuePair<string, string>(name, string.Format(CultureInfo.InvariantCulture, format, values));
    }
}
