using System.Collections.Generic;
using System.Globalization;

namespace FastPoints.Reading
{
    // The displayed facts of a CRS in well-known text: name, EPSG codes, length of the unit. WKT 1 and 2.
    internal static class WktCoordinateSystem
    {
        static readonly string[] s_authority = { "AUTHORITY", "ID" };
        static readonly string[] s_compound = { "COMPD_CS", "COMPOUNDCRS" };
        static readonly string[] s_projected = { "PROJCS", "PROJCRS", "PROJECTEDCRS" };
        static readonly string[] s_geographic = { "GEOGCS", "GEOGCRS", "GEOGRAPHICCRS", "GEODCRS", "GEODETICCRS" };
        static readonly string[] s_geocentric = { "GEOCCS" };
        static readonly string[] s_local = { "LOCAL_CS", "ENGCRS", "ENGINEERINGCRS" };
        static readonly string[] s_bound = { "BOUNDCRS" };
        static readonly string[] s_vertical = { "VERT_CS", "VERTCS", "VERTCRS", "VERTICALCRS" };
        static readonly string[] s_unit = { "UNIT", "LENGTHUNIT" };

        static readonly (string[] Keywords, CrsKind Kind)[] s_kinds =
        {
            (s_projected, CrsKind.Projected), (s_geographic, CrsKind.Geographic), (s_geocentric, CrsKind.Geocentric),
            (s_local, CrsKind.Local), (s_vertical, CrsKind.Vertical),
        };

        // False if it is no well-known text; the system is then unchanged.
        public static bool Read(string wkt, CoordinateSystem crs)
        {
            var root = WktNode.Parse(wkt, out int end);
            if (root == null || root.Values.Count == 0 && root.Children.Count == 0)
                return false;
            var whole = Unbound(root);
            var horizontal = whole;
            WktNode vertical = whole.Is(s_vertical) ? whole : null;
            // ESRI writes the vertical system after the horizontal one: PROJCS[...],VERTCS[...].
            if (vertical == null && WktNode.Parse(wkt.Substring(end), out _) is WktNode behind && behind.Is(s_vertical))
                vertical = behind;
            if (whole.Is(s_compound))
            {
                vertical = ComponentOf(whole, true);
                horizontal = ComponentOf(whole, false) ?? whole;
            }
            crs.Wkt = wkt;
            crs.Name = whole.Values.Count > 0 ? whole.Values[0] : null;
            crs.Kind = KindOf(horizontal);
            crs.Epsg = EpsgOf(whole);
            if (crs.Epsg == 0)
                crs.Epsg = EpsgOf(horizontal);
            crs.VerticalEpsg = vertical != horizontal ? EpsgOf(vertical) : 0;
            crs.MetresPerUnit = vertical == horizontal ? 0 : MetresOfUnit(horizontal);
            // A third axis has its own unit, as the height above an ellipsoid beside degrees.
            crs.VerticalMetresPerUnit = vertical != null
                ? LengthOf(vertical) : MetresOfUnit(ThirdAxis(horizontal)?.Child(s_unit));
            return true;
        }

        // A bound system contains the actual one beside a transformation.
        static WktNode Unbound(WktNode node) => node.Is(s_bound) && node.Child("SOURCECRS") is WktNode source &&
            source.Children.Count > 0 ? source.Children[0] : node;

        static WktNode ComponentOf(WktNode compound, bool isVertical)
        {
            foreach (var child in compound.Children)
            {
                var part = Unbound(child);
                if (KindOf(part) != CrsKind.Unknown && part.Is(s_vertical) == isVertical)
                    return part;
            }
            return null;
        }

        static CrsKind KindOf(WktNode system)
        {
            foreach (var (keywords, kind) in s_kinds)
                if (system.Is(keywords))
                    // WKT 2 writes geocentric systems with the geographic ones' keyword.
                    return kind == CrsKind.Geographic && IsCartesian(system.Child("CS")) ? CrsKind.Geocentric : kind;
            return CrsKind.Unknown;
        }

        static int EpsgOf(WktNode node)
        {
            var authority = node?.Child(s_authority);
            return authority != null && authority.Values.Count >= 2 && authority.Values[0].ToUpperInvariant() == "EPSG"
                && int.TryParse(authority.Values[1], NumberStyles.None, CultureInfo.InvariantCulture, out int code)
                ? code
                : 0;
        }

        static double MetresOfUnit(WktNode horizontal)
        {
            if (horizontal == null)
                return 0;
            if (horizontal.Is(s_unit))
                return Metres(horizontal);
            return KindOf(horizontal) == CrsKind.Geographic ? IsInDegrees(horizontal) ? double.NaN : 0 : LengthOf(horizontal);
        }

        // Grads and the like are no degrees: their unit stays unknown.
        static bool IsInDegrees(WktNode geographic)
        {
            var unit = geographic.Child("UNIT", "ANGLEUNIT") ?? geographic.Child("AXIS")?.Child("UNIT", "ANGLEUNIT");
            return unit == null || unit.Values.Count < 2 || !NumberText.TryRead(unit.Values[1], out double radians) ||
                System.Math.Abs(radians - System.Math.PI / 180) < 1e-5;
        }

        static bool IsCartesian(WktNode axes) =>
            axes != null && axes.Values.Count > 0 && axes.Values[0].ToUpperInvariant() == "CARTESIAN";

        // WKT 1 and most of WKT 2 give the unit of the whole system; WKT 2 may give it axis by axis instead.
        static double LengthOf(WktNode system) => Metres(system.Child(s_unit) ?? system.Child("AXIS")?.Child(s_unit));

        static double Metres(WktNode unit) => unit != null && unit.Values.Count >= 2 &&
            NumberText.TryRead(unit.Values[1], out double metres) && metres > 0 && !double.IsInfinity(metres) ? metres : 0;

        static WktNode ThirdAxis(WktNode system)
        {
            int axes = 0;
            foreach (var child in system.Children)
                if (child.Keyword == "AXIS" && ++axes == 3)
                    return child;
            return null;
        }
    }

    // One KEYWORD[...] of well-known text (OGC 01-009, ISO 19162).
    internal sealed class WktNode
    {
        const int MaxDepth = 64; // Text that is nested deeper than any CRS is not followed.

        public readonly string Keyword;
        public readonly List<string> Values = new List<string>();
        public readonly List<WktNode> Children = new List<WktNode>();

        WktNode(string keyword) => Keyword = keyword;

        // The outermost node, or null. Truncated text gives the nodes before its end.
        public static WktNode Parse(string text, out int at)
        {
            var open = new Stack<WktNode>();
            WktNode root = null;
            at = 0;
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
                    at = System.Math.Min(end + 1, text.Length);
                }
                else if (c == ']' || c == ')')
                {
                    at++;
                    if (open.Count > 0)
                        open.Pop();
                    if (open.Count == 0)
                        return root;
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

        public bool Is(string[] keywords) => System.Array.IndexOf(keywords, Keyword) >= 0;

        public WktNode Child(params string[] keywords)
        {
            foreach (var child in Children)
                if (child.Is(keywords))
                    return child;
            return null;
        }

        static bool IsPlain(char c) => char.IsLetterOrDigit(c) || c == '_' || c == '.' || c == '-' || c == '+';
    }
}
