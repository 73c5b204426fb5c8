namespace StandIns.Entities;

/// <summary>The entities of one world. Main thread.</summary>
sealed class EntityStore : IDisposable
{
    readonly List<Archetype> m_archetypes = new List<Archetype>();
    readonly Stack<int> m_free = new Stack<int>();
    Place[] m_places = new Place[64];
    int m_used = 1;

    struct Place
    {
        public int Version;
        public Archetype Archetype;
        public int Row;
        public bool IsDestroyed;
    }

    const int ChunkBytes = 16320;

    public bool IsDisposed { get; private set; }

    public EntityStore Alive => !IsDisposed ? this
        : throw new ObjectDisposedException("EntityManager", "The world has been disposed.");

    public int StructuralVersion { get; private set; }

    /// <summary>Systems that iterate over entities now, as by SystemAPI.Query: meanwhile no entity comes, goes or changes its
    /// components.</summary>
    public int Iterations { get; set; }

    void BeginStructuralChange()
    {
        if (Iterations > 0)
            throw new InvalidOperationException("Structural changes are not allowed while iterating over entities. Please use "
                + "EntityCommandBuffer instead.");
    }
    public int ArchetypeCount => m_archetypes.Count;

    public Archetype ArchetypeAt(int index) => m_archetypes[index];

    public Archetype ArchetypeOf(ReadOnlySpan<int> types)
    {
        Span<int> sorted = stackalloc int[types.Length];
        int count = 0;
        foreach (int type in types)
        {
            if (sorted.Slice(0, count).IndexOf(type) >= 0)
                throw new ArgumentException("It is not allowed to have two components of the same type on the same entity. ("
                    + TypeRegistry.InfoOf(type).Type + ")");
            sorted[count++] = type;
        }
        for (int i = 1; i < count; i++)
            for (int j = i; j > 0 && sorted[j] < sorted[j - 1]; j--)
                (sorted[j], sorted[j - 1]) = (sorted[j - 1], sorted[j]);
        foreach (var archetype in m_archetypes)
            if (sorted.SequenceEqual(archetype.Types))
                return archetype;
        int bytes = UnsafeUtility.SizeOf<Entity>();
        foreach (int type in sorted)
            bytes += TypeRegistry.InfoOf(type).SizeBytes;
        if (bytes > ChunkBytes)
            throw new ArgumentException($"Archetype too large to fit in chunk: {bytes} bytes of at most {ChunkBytes}");
        var made = new Archetype(sorted.ToArray());
        m_archetypes.Add(made);
        return made;
    }

    public Entity Create(Archetype archetype)
    {
        BeginStructuralChange();
        StructuralVersion++;
        if (!m_free.TryPop(out int index))
        {
            index = m_used++;
            if (index == m_places.Length)
                Array.Resize(ref m_places, 2 * index);
        }
        ref var place = ref m_places[index];
        var entity = new Entity { Index = index, Version = ++place.Version };
        place.Archetype = archetype;
        place.Row = archetype.Add(entity);
        return entity;
    }

    /// <param name="left">The component that the copy does not have; cleanup components it never has.</param>
    public Entity Copy(EntityStore store, Entity source, int left = -1)
    {
        var from = store.Find(source);
        if (from.IsDestroyed)
            throw new ArgumentException("srcEntity is not instantiable because it has already been destroyed.");
        Span<int> types = stackalloc int[from.Archetype.Types.Length];
        int count = 0;
        foreach (var column in from.Archetype.Columns)
            if (column.TypeIndex != left && !column.Info.IsCleanup)
                types[count++] = column.TypeIndex;
        var archetype = ArchetypeOf(types.Slice(0, count));
        var copy = Create(archetype);
        foreach (var column in archetype.Columns)
            from.Archetype.Find(column.TypeIndex).Copy(from.Row, column, m_places[copy.Index].Row);
        return copy;
    }

    public void Destroy(Entity entity)
    {
        BeginStructuralChange();
        // As in Unity: one that is gone is passed over.
        if (!Exists(entity) || m_places[entity.Index].IsDestroyed)
            return;
        var archetype = m_places[entity.Index].Archetype;
        if (!archetype.HasCleanup)
        {
            Erase(entity);
            return;
        }
        var kept = new List<int>();
        foreach (var column in archetype.Columns)
            if (column.Info.IsCleanup)
                kept.Add(column.TypeIndex);
        Move(entity, ArchetypeOf(kept.ToArray()));
        m_places[entity.Index].IsDestroyed = true;
    }

    public bool Exists(Entity entity) => entity.Index > 0 && entity.Index < m_used &&
        m_places[entity.Index].Version == entity.Version && m_places[entity.Index].Archetype != null;

    public bool Has(Entity entity, int type) => Exists(entity) && m_places[entity.Index].Archetype.Find(type) != null;

    public bool Add(Entity entity, int type)
    {
        BeginStructuralChange();
        if (!Exists(entity))
            throw new InvalidOperationException("The entity does not exist: " + entity);
        var archetype = m_places[entity.Index].Archetype;
        if (archetype.Find(type) != null)
            return false;
        var types = new int[archetype.Types.Length + 1];
        archetype.Types.CopyTo(types, 0);
        types[types.Length - 1] = type;
        Move(entity, ArchetypeOf(types));
        return true;
    }

    public bool Remove(Entity entity, int type)
    {
        BeginStructuralChange();
        if (!Exists(entity))
            return false;
        var archetype = m_places[entity.Index].Archetype;
        if (archetype.Find(type) == null)
            return false;
        var types = Array.FindAll(archetype.Types, t => t != type);
        if (types.Length == 0 && m_places[entity.Index].IsDestroyed)
            Erase(entity);
        else
            Move(entity, ArchetypeOf(types));
        return true;
    }

    public ComponentColumn Column(Entity entity, int type, out int row)
    {
        var place = Find(entity);
        row = place.Row;
        return place.Archetype.Find(type) ?? throw new ArgumentException("A component with type:" +
            TypeRegistry.InfoOf(type).Type.Name + " has not been added to the entity.");
    }

    public void Dispose()
    {
        foreach (var archetype in m_archetypes)
            archetype.Dispose();
        m_archetypes.Clear();
        IsDisposed = true;
    }

    Place Find(Entity entity)
    {
        if (!Exists(entity))
            throw new ArgumentException("The entity does not exist: " + entity);
        return m_places[entity.Index];
    }

    void Move(Entity entity, Archetype to)
    {
        StructuralVersion++;
        var from = m_places[entity.Index];
        int row = to.Add(entity);
        foreach (var column in from.Archetype.Columns)
        {
            if (to.Find(column.TypeIndex) is ComponentColumn kept)
                column.Move(from.Row, kept, row);
            else
                column.Free(from.Row);
        }
        RemoveRow(from);
        m_places[entity.Index].Archetype = to;
        m_places[entity.Index].Row = row;
    }

    void Erase(Entity entity)
    {
        StructuralVersion++;
        ref var place = ref m_places[entity.Index];
        foreach (var column in place.Archetype.Columns)
            column.Free(place.Row);
        RemoveRow(place);
        place.Archetype = null;
        place.IsDestroyed = false;
        place.Version++;
        m_free.Push(entity.Index);
    }

    void RemoveRow(Place place)
    {
        var moved = place.Archetype.Remove(place.Row);
        if (moved != Entity.Null)
            m_places[moved.Index].Row = place.Row;
    }
}
