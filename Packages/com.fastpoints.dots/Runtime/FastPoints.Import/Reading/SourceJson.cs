using System.Text;
using FastPoints.Core;

namespace FastPoints.Reading
{
    /// <summary>The JSON index of a source (Potree's cloud.js and metadata.json, ept.json), whose members are requested by name.
    /// A missing member, or one of another type, is a failure that names the file and the member.</summary>
    internal static class SourceJson
    {
        /// <summary>Larger texts are not parsed: the objects would take some 50 times the bytes.</summary>
        public const int MaxBytes = 4 << 20;

        /// <summary>Whether the first bytes of a file look like a JSON object, a byte order mark in front or not.</summary>
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

        /// <summary>Reads and parses the file. Trailing commas are accepted, since such files are edited by hand.</summary>
        /// <exception cref="PointCloudException">It is not a JSON object, or is too long for an index.</exception>
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
