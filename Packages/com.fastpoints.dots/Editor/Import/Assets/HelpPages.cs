using System;
using System.Collections.Generic;
using System.IO;
using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary>Knows where pages of the manual are: at the documentationUrl of package.json, or else in the package
    /// itself.</summary>
    [InitializeOnLoad]
    internal static class HelpPages
    {
        const string Package = "Packages/com.fastpoints.dots";

        // Inspectors ask each time they are drawn.
        static readonly Dictionary<string, string> s_urls = new Dictionary<string, string>();

        static HelpPages() => HelpPageAttribute.UrlOf = UrlOf;

        static string UrlOf(string page)
        {
            if (!s_urls.TryGetValue(page, out string url))
                s_urls[page] = url = UrlOf(page, Path.GetFullPath(FileUtil.GetPhysicalPath(Package)));
            return url;
        }

        internal static string UrlOf(string page, string package)
        {
            string manifest = Path.Combine(package, "package.json");
            if (File.Exists(manifest) && JsonReader.Parse(File.ReadAllText(manifest)) is Dictionary<string, object> members &&
                members.TryGetValue("documentationUrl", out object site) && Uri.TryCreate(site as string, UriKind.Absolute,
                    out var index))
                // A site's pages are beside its index, of the same kind.
                return new Uri(index, page + (index.AbsolutePath.EndsWith(".md", StringComparison.Ordinal) ? ".md" : ".html"))
                    .AbsoluteUri;
            string local = Path.Combine(package, "Documentation~", page + ".md");
            return File.Exists(local) ? new Uri(local).AbsoluteUri : "";
        }
    }
}
