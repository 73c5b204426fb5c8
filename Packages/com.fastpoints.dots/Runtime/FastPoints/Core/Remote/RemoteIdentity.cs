using System;
using System.Globalization;

namespace FastPoints
{
    // Which version of a file a server has.
    internal sealed class RemoteIdentity
    {
        public RemoteIdentity(long length, string tag, string modified)
        {
            Length = length;
            Tag = tag ?? "";
            Modified = modified ?? "";
        }

        public long Length { get; }

        public string Tag { get; } // ETag, as the server writes it; empty for none.

        public string Modified { get; } // Last-Modified, likewise.

        // An answer may lack what another has; the length always counts.
        public bool Fits(RemoteIdentity other) => Length == other.Length && (Tag.Length > 0 && other.Tag.Length > 0
            ? Tag == other.Tag : Modified.Length == 0 || other.Modified.Length == 0 || Modified == other.Modified);

        public override string ToString() =>
            Length.ToString(CultureInfo.InvariantCulture) + "\n" + Tag + "\n" + Modified;

        public static RemoteIdentity Parse(string text)
        {
            var lines = text.Split('\n');
            return lines.Length == 3 && long.TryParse(lines[0], NumberStyles.None, CultureInfo.InvariantCulture, out long length)
                ? new RemoteIdentity(length, lines[1], lines[2]) : null;
        }
    }

    // An address's part of the keys of a cache: without what signs it.
    internal static class RemoteKey
    {
        static readonly string[] s_signatures =
        {
            "sig", "se", "sp", "sv", "st", "sr", "spr", "sip", "ske", "skoid", "sks", "skt", "sktid", "skv", // Azure
            "signature", "expires", "policy", "key-pair-id", "awsaccesskeyid", "googleaccessid", // CloudFront, S3, Google
            "token", "access_token", "auth",
        };

        public static string Of(string address)
        {
            int query = address.IndexOf('?');
            if (query < 0)
                return SourcePath.WithoutQuery(address);
            int fragment = address.IndexOf('#', query);
            string kept = "";
            string[] pairs = address.Substring(query + 1, (fragment < 0 ? address.Length : fragment) - query - 1).Split('&');
            Array.Sort(pairs, string.CompareOrdinal);
            foreach (string pair in pairs)
                if (pair.Length > 0 && !IsSignature(pair.Split('=')[0]))
                    kept += (kept.Length == 0 ? "?" : "&") + pair;
            return address.Substring(0, query) + kept;
        }

        static bool IsSignature(string name)
        {
            name = name.ToLowerInvariant();
            return name.StartsWith("x-amz-", StringComparison.Ordinal) || name.StartsWith("x-goog-", StringComparison.Ordinal) ||
                Array.IndexOf(s_signatures, name) >= 0;
        }
    }
}
