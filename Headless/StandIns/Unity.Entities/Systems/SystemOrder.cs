using System;
using System.Collections.Generic;
using System.Reflection;
using Unity.Entities;

namespace StandIns.Entities
{
    /// <summary>The order of a group's systems: first those that are OrderFirst, last those that are OrderLast, and among each as
    /// UpdateBefore and UpdateAfter ask; what is left by name, so that it is always the same.</summary>
    static class SystemOrder
    {
        public static void Sort(List<ComponentSystemBase> systems, Type group)
        {
            var left = new List<ComponentSystemBase>(systems);
            left.Sort((a, b) => string.CompareOrdinal(a.GetType().FullName, b.GetType().FullName));
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

        static int PartOf(Type system, Type group)
        {
            foreach (var member in system.GetCustomAttributes<UpdateInGroupAttribute>())
                if (member.GroupType == group)
                    return member.OrderFirst ? 0 : member.OrderLast ? 2 : 1;
            return 1;
        }
    }
}
