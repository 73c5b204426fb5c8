using System.Collections.Generic;
using System.Globalization;

namespace FastPoints.Reading
{
    // What is shown of a CRS in well-known text: name, EPSG codes, length of the unit. WKT 1 and 2.
    internal static class WktCoordinateSystem
    {
        static readonly string[] s_authority = { "AUTHORITY", "ID" };
        static readonly string[] s_compound = { "COMPD_CS", "COMPOUNDCRS" };
        static readonly string[] s_geographic = { "GEOGCS", "GEOGCRS", "GEOGRAPHICCRS", "GEODCRS", "GEODETICCRS" };
        static readonly string[] s_horizontal =
        {
            "PROJCS", "PROJCRS", "PROJECTEDCRS", "GEOGCS", "GEOGCRS", "GEOGRAPHICCRS", "GEODCRS", "GEODETICCRS", "GEOCCS",
            "LOCAL_CS", "ENGCRS", "BOUNDCRS",
        };
        static readonly string[] s_vertical = { "VERT_CS", "VERTCRS", "VERTICALCRS" };
        static readonly string[] s_unit = { "UNIT", "LENGTHUNIT" };

        // False if it is no well-known text at all; nothing is filled in then.
        public static bool Read(string wkt, CoordinateSystem crs)
        {
            var root = WktNode.Parse(wkt);
            if (root == null || root.Values.Count == 0 && root.Children.Count == 0)
                return false;
            bool isCompound = System.Array.IndexOf(s_compound, root.Keyword) >= 0;
            var horizontal = isCompound ? root.Child(s_horizontal) ?? root : root;
            crs.Wkt = wkt;
            crs.Name = root.Values.Count > 0 ? root.Values[0] : null;
            crs.Epsg = EpsgOf(root);
            if (crs.Epsg == 0)
                crs.Epsg = EpsgOf(horizontal);
            crs.VerticalEpsg = isCompound ? EpsgOf(root.Child(s_vertical)) : 0;
            crs.MetresPerUnit = UnitOf(horizontal);
            return true;
        }

        static int EpsgOf(WktNode node)
        {
            var authority = node?.Child(s_authority);
            return authority != null && authority.Values.Count >= 2 && authority.Values[0].ToUpperInvariant() == "EPSG"
                && int.TryParse(authority.Values[1], NumberStyles.None, CultureInfo.InvariantCulture, out int code)
                ? code
                : 0;
        }

        static double UnitOf(WktNode horizontal)
        {
            if (System.Array.IndexOf(s_geographic, horizontal.Keyword) >= 0)
                return IsCartesian(horizontal.Child("CS")) ? LengthOf(horizontal) : double.NaN;
            return LengthOf(horizontal);
        }

        // WKT 2 writes geocentric systems with the geographic ones' keyword.
        static bool IsCartesian(WktNode axes) =>
            axes != null && axes.Values.Count > 0 && axes.Values[0].ToUpperInvariant() == "CARTESIAN";

        // WKT 1 and most of WKT 2 give the unit of the whole system; WKT 2 may give it axis by axis instead.
        static double LengthOf(WktNode system)
        {
            var unit = system.Child(s_unit) ?? system.Child("AXIS")?.Child(s_unit);
            return unit != null && unit.Values.Count >= 2 && NumberText.TryRead(unit.Values[1], out double metres)
                && metres > 0 && !double.IsInfinity(metres)
                ? metres
                : 0;
        }
    }

    // One KEYWORD[...] of well-known text (OGC 01-009, ISO 19162).
    internal sealed class WktNode
    {
        // Text that is nested deeper than any CRS is not followed.
        const int MaxDepth = 64;

        public readonly string Keyword;
        public readonly List<string> Values = new List<string>();
        public readonly List<WktNode> Children = new List<WktNode>();

        WktNode(string keyword) => Keyword = keyword;

        // The outermost node, or null. Text that breaks off gives what comes before.
        public static WktNode Parse(string text)
        {
            var open = new Stack<WktNode>();
            WktNode root = null;
            int at = 0;
            while (at < text.Length)
            {
                char c = text[at];
                if (c == '"')
                {
                    int end = at + 1;
                    while (end < text.Length && (text[end] != '"' || end + 1 < text.Length && text[end + 1] == '"'))
                        end += text[end] == '"' ? 2 : 1;
                    end = end < text.Length ? end : text.Length;
                    if (open.Count > 0)
                        open.Peek().Values.Add(text.Substring(at + 1, end - at - 1).Replace("\"\"", "\""));
                    at = end + 1;
                }
                else if (c == ']' || c == ')')
                {
                    if (open.Count > 0)
                        open.Pop();
                    if (open.Count == 0)
                        return root;
                    at++;
                }
                else if (IsPlain(c))
                {
                    int end = at;
                    while (end < text.Length && IsPlain(text[end]))
                        end++;
                    string word = text.Substring(at, end - at);
                    while (end < text.Length && char.IsWhiteSpace(text[end]))
                        end++;
                    at = end;
                    if (end == text.Length || text[end] != '[' && text[end] != '(')
                    {
                        if (open.Count > 0)
                            open.Peek().Values.Add(word);
                        continue;
                    }
                    if (open.Count == MaxDepth)
                        return root;
                    var node = new WktNode(word.ToUpperInvariant());
                    if (open.Count > 0)
                        open.Peek().Children.Add(node);
                    root = root ?? node;
                    open.Push(node);
                    at++;
                }
                else
                {
                    at++;
                }
            }
            return root;
        }

        public WktNode Child(params string[] keywords)
        {
            foreach (var child in Children)
                if (System.Array.IndexOf(keywords, child.Keyword) >= 0)
                    return child;
            return null;
        }

        static bool IsPlain(char c) => char.IsLetterOrDigit(c) || c == '_' || c == '.' || c == '-' || c == '+';
    }
}
