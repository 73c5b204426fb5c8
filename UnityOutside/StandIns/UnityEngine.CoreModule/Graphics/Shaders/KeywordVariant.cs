namespace StandIns.Graphics;

/// <summary>Which keyword of each group is on, as one number: a digit a group, the first group's the lowest.</summary>
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

    /// <summary>How many there are.</summary>
    internal static long Count(KeywordGroup[] groups)
    {
        long count = 1;
        foreach (KeywordGroup group in groups)
            count *= group.Keywords.Length;
        return count;
    }

    /// <summary>The keywords that a stage, as glslang calls it, is compiled with.</summary>
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
