namespace StandIns.Entities;

/// <summary>The order of a group's systems: first those that are OrderFirst, last those that are OrderLast, and among each as
/// UpdateBefore and UpdateAfter ask. What is left is by name, forwards or backwards: in Unity by a hash, which nobody
/// chooses.</summary>
static class SystemOrder
{
    internal static bool IsBackwards { get; set; } // Whether what no attribute orders runs from Z to A.

    public static void Sort(List<ComponentSystemBase> systems, Type group)
    {
        var left = new List<ComponentSystemBase>(systems);
        left.Sort((a, b) => string.CompareOrdinal(a.GetType().FullName, b.GetType().FullName) * (IsBackwards ? -1 : 1));
        Warn(systems, group);
        systems.Clear();
        while (left.Count > 0)
        {
            int next = left.FindIndex(s => !left.Exists(other => other != s && MustPrecede(other.GetType(), s.GetType(), group)));
            if (next < 0)
                throw new InvalidOperationException("The systems of " + group.Name + " wait for one another: " +
                    string.Join(", ", left.ConvertAll(s => s.GetType().Name)));
            systems.Add(left[next]);
            left.RemoveAt(next);
        }
    }

    static bool MustPrecede(Type first, Type second, Type group)
    {
        int firstPart = PartOf(first, group), secondPart = PartOf(second, group);
        if (firstPart != secondPart)
            return firstPart < secondPart;
        foreach (var before in first.GetCustomAttributes<UpdateBeforeAttribute>())
            if (before.SystemType == second)
                return true;
        foreach (var after in second.GetCustomAttributes<UpdateAfterAttribute>())
            if (after.SystemType == first)
                return true;
        return false;
    }

    /// <summary>Where a system has an attribute that Unity ignores, everybody's Console names each of its attributes that order
    /// nothing.</summary>
    static void Warn(List<ComponentSystemBase> systems, Type group)
    {
        foreach (var system in systems)
        {
            var type = system.GetType();
            int PartsAhead(Type other) => PartOf(other, group) - PartOf(type, group);
            bool IsThere(Type other) => systems.Exists(s => s.GetType() == other);
            var before = type.GetCustomAttributes<UpdateBeforeAttribute>().Select(a => a.SystemType).ToArray();
            var after = type.GetCustomAttributes<UpdateAfterAttribute>().Select(a => a.SystemType).ToArray();
            bool IsLost(Type other) => other == type || (PartsAhead(other) == 0 && !IsThere(other));
            if (!Array.Exists(before, b => IsLost(b) || PartsAhead(b) < 0)
                && !Array.Exists(after, a => IsLost(a) || PartsAhead(a) > 0))
                continue;
            foreach (var other in after.Concat(before))
            {
                string reason = other == type ? "a system cannot be updated or created after or before itself."
                    : !IsThere(other) ? "they are not members of the same ComponentSystemGroup instance, " + group
                    : PartsAhead(other) != 0 ? "OrderFirst/OrderLast has higher precedence." : null;
                if (reason != null)
                    UnityEngine.Debug.LogWarning($"Ignoring invalid order of {type} and {other}: {reason}");
            }
        }
    }

    static int PartOf(Type system, Type group)
    {
        foreach (var member in system.GetCustomAttributes<UpdateInGroupAttribute>())
            if (member.GroupType == group)
                return member.OrderFirst ? 0 : member.OrderLast ? 2 : 1;
        return 1;
    }
}
