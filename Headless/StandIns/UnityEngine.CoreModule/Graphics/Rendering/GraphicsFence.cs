using StandIns.Graphics;

namespace UnityEngine.Rendering
{
    /// <summary>Tells whether the device has come to a certain command.</summary>
    public struct GraphicsFence
    {
        // The submission of each of the last fences; before it is executed a fence has none.
        const int Kept = 1024;
        static readonly ulong[] s_submissionOf = new ulong[Kept];
        static int s_last;

        int m_id;

        /// <summary>Also true for a fence so old that a thousand came after it.</summary>
        public bool passed => m_id <= s_last - Kept || (s_submissionOf[m_id % Kept] is var number && number > 0
            && GpuDevice.Current.Queue.HasPassed(number));

        internal readonly int Id => m_id;

        internal static GraphicsFence Create()
        {
            s_last++;
            s_submissionOf[s_last % Kept] = 0;
            return new GraphicsFence { m_id = s_last };
        }

        internal static void Execute(int id, ulong submission) => s_submissionOf[id % Kept] = submission;
    }
}
