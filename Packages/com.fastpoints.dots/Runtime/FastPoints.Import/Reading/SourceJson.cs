using System.Text;
using FastPoints.Core;

namespace FastPoints.Reading
{
    internal static class SourceJson
    {
        /// <summary>Larger texts are not parsed: the objects would take some 50 times the bytes.</summary>
        public const int MaxBytes = 4 << 20;

        // Also with a byte order mark in front.
        public static bool Is(byte[] head)
        {
            int at = head.Length >= 3 && head[0] == 0xEF && head[1] == 0xBB && head[2] == 0xBF ? 3 : 0;
            while (at < head.Length && (head[at] == ' ' || head[at] >= 9 && head[at] <= 13))
                at++;
            if (at == head.Length || head[at] != '{')
                return false;
            for (int i = at; i < head.Length; i++)
                if (head[i] == 0)
                    return false;
            return true;
        }

        // Trailing commas are accepted, since such files are edited by hand.
        public static JsonMembers Read(FileSource source)
        {
            if (source.Length > MaxBytes)
                throw PointCloudException.Wanted(FailureCode.Unsupported, source.Path, 0, "bytes of a JSON index",
                    "at most " + MaxBytes, source.Length);
            string text = Encoding.UTF8.GetString(source.ReadUpTo(0, (int)source.Length).Bytes).TrimStart('\uFEFF');
            return JsonMembers.Parse(text, source.Path, true, source.Length);
        }
    }
}
