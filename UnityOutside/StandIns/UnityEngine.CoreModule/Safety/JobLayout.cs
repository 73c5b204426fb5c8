namespace StandIns.Safety;

sealed class JobField
{
    internal FieldInfo[] Path;
    internal ContainerType Type;
    internal int Offset;
    internal string Name;
    internal int NameId;
    internal bool IsReadOnly;
    internal bool IsWriteOnly;
    internal bool DisablesSafety;
    internal bool DisablesParallelForRestriction;
    internal bool IsDeallocated;

    internal bool Writes => !IsReadOnly;
}

/// <summary>The fields of a job struct that the job system looks at, found once by reflection. Offsets are computed when they are
/// first wanted: a job without special fields never pays for them in Release.</summary>
sealed class JobLayout
{
    internal const BindingFlags InstanceFields = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic
        | BindingFlags.DeclaredOnly;

    static readonly ConcurrentDictionary<Type, JobLayout> s_layouts = new ConcurrentDictionary<Type, JobLayout>();

    readonly Type m_job;
    readonly List<JobField> m_fields = new List<JobField>();
    readonly List<FieldInfo[]> m_threadIndexPaths = new List<FieldInfo[]>();
    readonly Lazy<JobField[]> m_containers;
    readonly Lazy<int[]> m_threadIndexOffsets;
    internal readonly string Refusal; // Why such a job cannot be scheduled, or null.

    JobLayout(Type job)
    {
        m_job = job;
        Walk(job, new List<FieldInfo>(), ref Refusal);
        m_containers = new Lazy<JobField[]>(Locate);
        m_threadIndexOffsets = new Lazy<int[]>(() => FieldOffsets.Of(m_job, m_threadIndexPaths));
    }

    internal JobField[] Containers => m_containers.Value;
    internal int[] ThreadIndexOffsets => m_threadIndexOffsets.Value;

    internal JobField[] Deallocated =>
        m_fields.Exists(f => f.IsDeallocated) ? Containers.Where(f => f.IsDeallocated).ToArray() : Array.Empty<JobField>();

    internal JobField[] Restricted =>
        Containers.Where(f => f.Type.SupportsMinMax && f.Writes && !f.DisablesParallelForRestriction).ToArray();

    internal static JobLayout Of(Type job) => s_layouts.GetOrAdd(job, j => new JobLayout(j));

    void Walk(Type type, List<FieldInfo> path, ref string refusal)
    {
        foreach (FieldInfo field in type.GetFields(InstanceFields))
        {
            path.Add(field);
            Type fieldType = field.FieldType;
            if (fieldType.IsPointer)
            {
                if (!field.IsDefined(typeof(NativeDisableUnsafePtrRestrictionAttribute), false))
                    refusal ??= $"{NameOf(path)} uses unsafe Pointers which is not allowed. Unsafe Pointers can lead to "
                        + "crashes and no safety against race conditions can be provided.\nIf you really need to use "
                        + "unsafe pointers, you can disable this check using [NativeDisableUnsafePtrRestriction].";
            }
            else if (!fieldType.IsValueType && !IsFunctionPointer(fieldType))
            {
                refusal ??= $"{NameOf(path)} is not a value type. Job structs may not contain any reference types.";
            }
            else if (field.IsDefined(typeof(NativeSetThreadIndexAttribute), false))
            {
                m_threadIndexPaths.Add(path.ToArray());
            }
            else if (ContainerType.Is(fieldType))
            {
                Add(fieldType, path);
            }
            else if (fieldType.IsValueType && !fieldType.IsPrimitive && !fieldType.IsEnum)
                Walk(fieldType, path, ref refusal);
            path.RemoveAt(path.Count - 1);
        }
    }

    void Add(Type type, List<FieldInfo> path)
    {
        m_fields.Add(new JobField
        {
            Path = path.ToArray(),
            Name = $"{SafetyNames.Of(type)} {NameOf(path)}",
            IsReadOnly = Has<ReadOnlyAttribute>(path) || type.IsDefined(typeof(NativeContainerIsReadOnlyAttribute), false),
            IsWriteOnly = Has<WriteOnlyAttribute>(path),
            DisablesSafety = Has<NativeDisableContainerSafetyRestrictionAttribute>(path),
            DisablesParallelForRestriction = Has<NativeDisableParallelForRestrictionAttribute>(path)
                || type.IsDefined(typeof(NativeContainerIsAtomicWriteOnlyAttribute), false),
            IsDeallocated = Has<DeallocateOnJobCompletionAttribute>(path),
        });
    }

    JobField[] Locate()
    {
        int[] offsets = FieldOffsets.Of(m_job, m_fields.ConvertAll(f => f.Path));
        for (int i = 0; i < offsets.Length; i++)
        {
            JobField field = m_fields[i];
            field.Offset = offsets[i];
            field.Type = ContainerType.Of(field.Path[field.Path.Length - 1].FieldType);
            field.NameId = SafetyNames.IdOf(field.Name);
        }
        return m_fields.ToArray();
    }

    string NameOf(List<FieldInfo> path) => m_job.Name + "." + string.Join(".", path.ConvertAll(f => f.Name));

    static bool Has<TAttribute>(List<FieldInfo> path) where TAttribute : Attribute =>
        path.Exists(f => f.IsDefined(typeof(TAttribute), false));

    static bool IsFunctionPointer(Type type)
    {
#if NET
        return type.IsFunctionPointer;
#else
        return false;
#endif
    }
}
