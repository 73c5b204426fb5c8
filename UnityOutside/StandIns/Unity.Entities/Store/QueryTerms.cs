namespace StandIns.Entities;

sealed class QueryTerms
{
    public readonly List<int> All = new List<int>();
    public readonly List<int> Any = new List<int>();
    public readonly List<int> None = new List<int>();
    public readonly List<int> Disabled = new List<int>();
    public readonly List<int> Present = new List<int>();

    static readonly int s_disabled = TypeRegistry.Of<Disabled>.Index.Value;
    static readonly int s_prefab = TypeRegistry.Of<Prefab>.Index.Value;
    public readonly List<int> Absent = new List<int>();
    public EntityQueryOptions Options;
    public bool HasOptions;
    public bool IsOfASystem;
    public bool IsDisposed;

    /// <summary>Refuses what Unity refuses when a query is made.</summary>
    public void Check()
    {
        var named = All.Concat(Any).Concat(None).Concat(Disabled).Concat(Present).Concat(Absent);
        if (named.GroupBy(t => t).FirstOrDefault(t => t.Count() > 1) is { } twice)
            throw new EntityQueryDescValidationException("EntityQuery contains a filter with duplicate component type name " +
                TypeRegistry.InfoOf(twice.Key).Type.Name);
        foreach (int type in Disabled)
            if (!TypeRegistry.InfoOf(type).IsEnableable)
                throw new InvalidOperationException("Component type " + TypeRegistry.InfoOf(type).Type +
                    " passed with WithDisabled() is not an enableable component");
    }

    public bool Declares(int type) =>
        All.Contains(type) || Any.Contains(type) || Disabled.Contains(type) || Present.Contains(type);

    /// <summary>For a query: who named these may go on.</summary>
    public QueryTerms Copy()
    {
        var copy = new QueryTerms { Options = Options };
        copy.All.AddRange(All);
        copy.Any.AddRange(Any);
        copy.None.AddRange(None);
        copy.Disabled.AddRange(Disabled);
        copy.Present.AddRange(Present);
        copy.Absent.AddRange(Absent);
        return copy;
    }

    public static QueryTerms Of(ComponentType[] types)
    {
        var terms = new QueryTerms();
        foreach (var type in types)
            (type.AccessModeType == ComponentType.AccessMode.Exclude ? terms.None : terms.All).Add(type.TypeIndex.Value);
        return terms;
    }

    /// <summary>Whether entities of an archetype can match, whatever is enabled. Makes no garbage, so that what a frame of
    /// systems makes is theirs.</summary>
    public bool MayMatch(Archetype archetype)
    {
        if (!HasEach(archetype, All) || !HasEach(archetype, Disabled) || !HasEach(archetype, Present))
            return false;
        if ((Options & EntityQueryOptions.IncludeDisabledEntities) == 0 && !All.Contains(s_disabled) &&
            archetype.Find(s_disabled) != null)
            return false;
        if ((Options & EntityQueryOptions.IncludePrefab) == 0 && archetype.Find(s_prefab) != null && !All.Contains(s_prefab))
            return false;
        foreach (int type in Absent)
            if (archetype.Find(type) != null)
                return false;
        foreach (int type in None)
            if (archetype.Find(type) is ComponentColumn column && !column.Info.IsEnableable)
                return false;
        return Any.Count == 0 || HasOne(archetype, Any);
    }

    static bool HasEach(Archetype archetype, List<int> types)
    {
        foreach (int type in types)
            if (archetype.Find(type) == null)
                return false;
        return true;
    }

    static bool HasOne(Archetype archetype, List<int> types)
    {
        foreach (int type in types)
            if (archetype.Find(type) != null)
                return true;
        return false;
    }

    public bool Matches(Archetype archetype, int row)
    {
        foreach (int type in All)
            if (!archetype.Find(type).IsEnabled(row))
                return false;
        foreach (int type in Disabled)
            if (archetype.Find(type).IsEnabled(row))
                return false;
        foreach (int type in None)
            if (archetype.Find(type) is ComponentColumn column && column.IsEnabled(row))
                return false;
        if (Any.Count == 0)
            return true;
        foreach (int type in Any)
            if (archetype.Find(type) is ComponentColumn column && column.IsEnabled(row))
                return true;
        return false;
    }
}
