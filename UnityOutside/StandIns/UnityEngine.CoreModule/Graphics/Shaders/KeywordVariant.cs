namespace StandIns.Graphics;

static class KeywordVariant
{
    internal static long Choose(KeywordGroup[] groups, KeywordSet local)
    {
        long variant = 0, scale = 1;
        foreach (KeywordGroup group in groups)
        {
            variant += group.Choose(local, KeywordSet.Global) * scale;
            scale *= group.Keywords.Length;
        }
        return variant;
    }

    internal static long Count(KeywordGroup[] groups)
    {
        long count = 1;
        foreach (KeywordGroup group in groups)
            count *= group.Keywords.Length;
        return count;
    }

    internal static IEnumerable<string> Names(KeywordGroup[] groups, long variant, string stage)
    {
        foreach (KeywordGroup group in groups)
        {
            string keyword = group.Keywords[variant % group.Keywords.Length];
            variant /= group.Keywords.Length;
            if (keyword != null && group.IsFor(stage))
                yield return keyword;
        }
    }
}
