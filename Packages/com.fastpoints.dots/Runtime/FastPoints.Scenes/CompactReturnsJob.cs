using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Scenes
{
    /// <summary>Closes the gaps between the lines' returns, in place.</summary>
    [BurstCompile]
    public struct CompactReturnsJob : IJob
    {
        public NativeArray<ScanReturn> Returns;
        [ReadOnly] public NativeArray<int> CountOfLine;
        public int Lines;
        public int ReturnsPerLine;
        public NativeReference<int> Count;

        public void Execute()
        {
            int end = 0;
            for (int line = 0; line < Lines; line++)
            {
                int start = line * ReturnsPerLine;
                int count = CountOfLine[line];
                if (start != end)
                    for (int i = 0; i < count; i++)
                        Returns[end + i] = Returns[start + i];
                end += count;
            }
            Count.Value = end;
        }
    }
}
