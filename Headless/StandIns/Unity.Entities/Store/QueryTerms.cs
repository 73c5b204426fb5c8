using System.Collections.Generic;
using Unity.Entities;

namespace StandIns.Entities
{
    /// <summary>What a query asks of an entity.</summary>
    sealed class QueryTerms
    {
        /// <summary>There, and enabled where it can be.</summary>
        public readonly List<int> All = new List<int>();

        /// <summary>Of these one at least: there, and enabled.</summary>
        public readonly List<int> Any = new List<int>();

        /// <summary>Not there, or disabled.</summary>
        public readonly List<int> None = new List<int>();

        /// <summary>There, and disabled.</summary>
        public readonly List<int> Disabled = new List<int>();

        /// <summary>There, whether enabled or not.</summary>
        public readonly List<int> Present = new List<int>();

        /// <summary>Not there.</summary>
        public readonly List<int> Absent = new List<int>();

        public static QueryTerms Of(ComponentType[] types)
        {
            var terms = new QueryTerms();
            foreach (var type in types)
                (type.AccessModeType == ComponentType.AccessMode.Exclude ? terms.None : terms.All).Add(type.TypeIndex.Value);
            return terms;
        }

        /// <summary>Whether entities of an archetype can match, whatever is enabled.</summary>
        public bool MayMatch(Archetype archetype) =>
            All.TrueForAll(t => archetype.Find(t) != null) && Disabled.TrueForAll(t => archetype.Find(t) != null) &&
            Present.TrueForAll(t => archetype.Find(t) != null) && Absent.TrueForAll(t => archetype.Find(t) == null) &&
            None.TrueForAll(t => archetype.Find(t) == null || archetype.Find(t).Info.IsEnableable) &&
            (Any.Count == 0 || Any.Exists(t => archetype.Find(t) != null));

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
}
