using System;
using System.IO;

namespace FastPoints
{
    // Paths of this machine's files and addresses (http, https, assets of an Android player) alike. What is written behind an
    // address's question mark, such as a signature, goes with its siblings.
    internal static class SourcePath
    {
        public const string StreamingAssetsPrefix = "jar:file://"; // As Android's streaming assets begin.

        public static bool IsStreamingAsset(string path) =>
            path != null && path.StartsWith(StreamingAssetsPrefix, StringComparison.Ordinal);

        public static bool IsRemote(string path) => path != null &&
            (IsStreamingAsset(path) || path.StartsWith("https://", StringComparison.OrdinalIgnoreCase) ||
             path.StartsWith("http://", StringComparison.OrdinalIgnoreCase));

        public static string Full(string path) => IsRemote(path) ? path : Path.GetFullPath(path);

        public static string Combine(string folder, string name)
        {
            if (!IsRemote(folder))
                return Path.Combine(folder, name);
            Split(folder, out string address, out string query);
            return address.TrimEnd('/') + "/" +
                (IsStreamingAsset(folder) ? name : Uri.EscapeDataString(name).Replace("%2F", "/")) + query;
        }

        // Of a file or a folder.
        public static string FolderOf(string path)
        {
            if (!IsRemote(path))
                return Path.GetDirectoryName(path);
            Split(path, out string address, out string query);
            address = address.TrimEnd('/');
            int slash = address.LastIndexOf('/');
            return slash > address.IndexOf("//", StringComparison.Ordinal) + 1 ? address.Substring(0, slash) + query : null;
        }

        public static string NameOf(string path)
        {
            if (!IsRemote(path))
                return Path.GetFileName(path);
            Split(path, out string address, out _);
            address = address.TrimEnd('/');
            string name = address.Substring(address.LastIndexOf('/') + 1);
            return IsStreamingAsset(path) ? name : Uri.UnescapeDataString(name);
        }

        // For messages and keys: signatures and tokens are never shown or stored.
        public static string WithoutQuery(string path)
        {
            if (!IsRemote(path))
                return path;
            Split(path, out string address, out _);
            return address;
        }

        static void Split(string path, out string address, out string query)
        {
            int at = IsStreamingAsset(path) ? -1 : path.IndexOfAny(s_ends);
            address = at < 0 ? path : path.Substring(0, at);
            query = at < 0 ? "" : path.Substring(at);
        }

        static readonly char[] s_ends = { '?', '#' };
    }
}
