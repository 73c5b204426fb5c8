#if ENABLE_UNITY_COLLECTIONS_CHECKS
using Random = System.Random;

namespace UnityOutside.Tests.StandIns;

public sealed unsafe class CollectionRulesTests
{
    const int HalfOfTwoGiB = 1 << 30;

    static NativeList<int> ListOf(params int[] values)
    {
        var list = new NativeList<int>(Allocator.Persistent);
        foreach (int value in values)
            list.Add(value);
        return list;
    }

    static NativeList<int> FullList()
    {
        var list = new NativeList<int>(Allocator.Persistent);
        list.ResizeUninitialized(list.Capacity);
        return list;
    }

    static NUnit.Framework.Constraints.IResolveConstraint OutOfRange => Throws.TypeOf<ArgumentOutOfRangeException>();

    [Test]
    public void List_OfMoreBytesThanUnityCounts_IsRefused()
    {
        Assert.That(() => new NativeList<long>(HalfOfTwoGiB / 4, Allocator.Persistent).Dispose(), OutOfRange);
        using var bytes = new NativeList<byte>(Allocator.Persistent);
        Assert.That(() => bytes.SetCapacity(HalfOfTwoGiB + 1), OutOfRange);
        Assert.That(() => bytes.ResizeUninitialized(HalfOfTwoGiB + 1), OutOfRange);
        using var longs = new NativeList<long>(Allocator.Persistent);
        Assert.That(() => longs.ResizeUninitialized(HalfOfTwoGiB / 4 + 1), OutOfRange);
        Assert.That((bytes.Length, longs.Length), Is.EqualTo((0, 0)));
    }

    [Test]
    public void List_NegativeLength_IsRefused()
    {
        using NativeList<int> list = ListOf(1);
        Assert.That(() => list.ResizeUninitialized(-1), OutOfRange);
        Assert.That(() => list.AddRange(list.GetUnsafePtr(), -1), OutOfRange);
    }

    [Test]
    public void List_OwnElementAddedDuringResize_IsRefused()
    {
        using NativeList<int> list = FullList();
        Assert.That(() => list.Add(in list.ElementAt(0)), Throws.InvalidOperationException);
        Assert.That(() => list.AddRange(list.AsArray()), Throws.InvalidOperationException);
        Assert.That(() => list.Add(list[0]), Throws.Nothing);
        Assert.That(() => list.Add(in list.ElementAt(1)), Throws.Nothing);
    }

    [Test]
    public void List_ViewOfIt_EndsWhenAnElementIsRemoved()
    {
        using NativeList<int> list = ListOf(1, 2, 3);
        NativeArray<int> view = list.AsArray();
        list.RemoveAt(0);
        Assert.That(() => view[0], Throws.TypeOf<ObjectDisposedException>());
        view = list.AsArray();
        list.RemoveAtSwapBack(0);
        Assert.That(() => view[0], Throws.TypeOf<ObjectDisposedException>());
        Assert.That(list[0], Is.EqualTo(3));
        view = list.AsArray();
        list.Clear();
        Assert.That(() => view[0], Throws.TypeOf<ObjectDisposedException>());
    }

    [Test]
    public void List_ResizedDuringEnumeration_Throws()
    {
        using NativeList<int> list = ListOf(1, 2);
        Assert.That(() =>
        {
            foreach (int value in list)
                list.Add(value);
        }, Throws.TypeOf<ObjectDisposedException>());
    }

    [Test]
    public void List_ThroughItsInterface_CannotBeEnumerated()
    {
        using NativeList<int> list = ListOf(1);
        Assert.That(() => ((IEnumerable<int>)list).GetEnumerator(), Throws.TypeOf<NotImplementedException>());
        Assert.That(() => ((System.Collections.IEnumerable)list).GetEnumerator(), Throws.TypeOf<NotImplementedException>());
    }

    [Test]
    public void Container_NeverCreated_ThrowsWhenUsed()
    {
        NativeArray<int> array = default;
        NativeList<int> list = default;
        NativeReference<int> reference = default;
        NativeParallelHashMap<int, int> map = default;
        Assert.That(new[] { array.IsCreated, list.IsCreated, reference.IsCreated, map.IsCreated }, Is.All.False);
        Assert.That(array.Length, Is.Zero);
        Assert.That(() => array[0], Throws.TypeOf<NullReferenceException>());
        Assert.That(() => list.Length, Throws.TypeOf<NullReferenceException>());
        Assert.That(() => list[0] = 5, Throws.TypeOf<NullReferenceException>());
        Assert.That(() => list.AsArray(), Throws.TypeOf<NullReferenceException>());
        Assert.That(() => reference.Value = 5, Throws.TypeOf<NullReferenceException>());
        Assert.That(() => map.ContainsKey(1), Throws.TypeOf<NullReferenceException>());
        Assert.That(() =>
        {
            array.Dispose();
            list.Dispose();
            reference.Dispose();
            map.Dispose();
        }, Throws.Nothing);
    }

    [Test]
    public void Container_DisposedTwice_Throws()
    {
        var reference = new NativeReference<int>(Allocator.Persistent);
        var map = new NativeParallelHashMap<int, int>(1, Allocator.Persistent);
        reference.Dispose();
        map.Dispose();
        Assert.That(() => reference.Dispose(), Throws.TypeOf<ObjectDisposedException>());
        Assert.That(() => map.Dispose(), Throws.TypeOf<ObjectDisposedException>());
    }

    [Test]
    public void Array_Empty_IsCreatedAndThrowsOnRead()
    {
        using var array = new NativeArray<int>(0, Allocator.Persistent);
        Assert.That((array.IsCreated, array.Length), Is.EqualTo((true, 0)));
        Assert.That(() => array[0], Throws.TypeOf<IndexOutOfRangeException>());
        Assert.That(array.ToArray(), Is.Empty);
    }

    [Test]
    public void Array_SubArrayOfNegativeLength_IsRefused()
    {
        using var array = new NativeArray<int>(4, Allocator.Persistent);
        Assert.That(() => array.GetSubArray(3, -1), OutOfRange);
    }

    [Test]
    public void Array_CopiedOntoItself_IsRefused()
    {
        using var array = new NativeArray<int>(new[] { 1, 2, 3, 4, 5 }, Allocator.Persistent);
        Assert.That(() => NativeArray<int>.Copy(array, 0, array, 1, 4), Throws.InvalidOperationException);
        Assert.That(() => NativeArray<int>.Copy(array, 1, array, 0, 4), Throws.InvalidOperationException);
        Assert.That(() => NativeArray<int>.Copy(array, 0, array, 3, 2), Throws.Nothing);
        Assert.That(array.ToArray(), Is.EqualTo(new[] { 1, 2, 3, 1, 2 }));
    }

    [Test]
    public void Array_CopiedWhereUnityCountsBytesAsInt_IsRefused()
    {
        // Nothing touches the memory, so the system gives none.
        using var large = new NativeArray<long>(HalfOfTwoGiB / 4 + 2, Allocator.Persistent,
            NativeArrayOptions.UninitializedMemory);
        using var one = new NativeArray<long>(1, Allocator.Persistent);
        Assert.That(() => NativeArray<long>.Copy(large, HalfOfTwoGiB / 4, one, 0, 1), OutOfRange);
        Assert.That(() => NativeArray<long>.Copy(one, 0, large, HalfOfTwoGiB / 4, 1), OutOfRange);
        Assert.That(() => large.CopyFrom(large), OutOfRange);
        Assert.That(() => large.GetSubArray(HalfOfTwoGiB / 4, 1).CopyFrom(one), Throws.Nothing);
    }

    struct AllocatingJob : IJob
    {
        public Allocator Allocator;

        public void Execute() => new NativeArray<int>(1, Allocator).Dispose();
    }

    [TestCase(Allocator.Persistent)]
    [TestCase(Allocator.TempJob)]
    public void Array_CreatedInAJob_UsesTempMemory(Allocator allocator)
    {
        Assert.That(() => new AllocatingJob { Allocator = allocator }.Schedule().CompleteAndThrow(),
            Throws.InvalidOperationException.With.Message.EqualTo("Jobs can only create Temp memory"));
        new AllocatingJob { Allocator = Allocator.Temp }.Schedule().Complete();
    }

    [TestCase(Allocator.Persistent)]
    [TestCase(Allocator.TempJob)]
    [TestCase(Allocator.Temp)]
    public void Memory_Uninitialized_HoldsAnything(Allocator allocator)
    {
        using var array = new NativeArray<uint>(100, allocator, NativeArrayOptions.UninitializedMemory);
        Assert.That(array.ToArray(), Is.All.EqualTo(0xCDCDCDCDu));
        using var list = new NativeList<uint>(allocator);
        list.ResizeUninitialized(100);
        Assert.That(list.AsArray().ToArray(), Is.All.EqualTo(0xCDCDCDCDu));
        list.Clear();
        list.Resize(100, NativeArrayOptions.ClearMemory);
        Assert.That(list.AsArray().ToArray(), Is.All.Zero);
    }

    [Test]
    public void MemCpy_OfMemoryThatOverlaps_IsRefused()
    {
        byte* memory = stackalloc byte[16];
        Assert.That(() => UnsafeUtility.MemCpy(memory + 1, memory, 8), Throws.InvalidOperationException);
        Assert.That(() => UnsafeUtility.MemCpy(memory, memory + 7, 8), Throws.InvalidOperationException);
        Assert.That(() => UnsafeUtility.MemCpy(memory, memory + 8, 8), Throws.Nothing);
        Assert.That(() => UnsafeUtility.MemCpy(memory, memory, 0), Throws.Nothing);
        Assert.That(() => UnsafeUtility.MemMove(memory + 1, memory, 8), Throws.Nothing);
    }

    [Test]
    public void Memory_OfNegativeSize_IsRefused()
    {
        byte* memory = stackalloc byte[16];
        Assert.That(() => UnsafeUtility.MemCpy(memory, memory + 8, -1), OutOfRange);
        Assert.That(() => UnsafeUtility.MemMove(memory, memory + 8, -1), OutOfRange);
        Assert.That(() => UnsafeUtility.MemSet(memory, 1, -1), OutOfRange);
        Assert.That(() => UnsafeUtility.MemClear(memory, -1), OutOfRange);
        Assert.That(() => UnsafeUtility.MemCmp(memory, memory + 8, -1), OutOfRange);
    }

    [Test]
    public void Map_OfMoreBytesThanUnityCounts_IsRefused() =>
        Assert.That(() => new NativeParallelHashMap<long, long>(HalfOfTwoGiB / 8, Allocator.Persistent).Dispose(), OutOfRange);

    [Test]
    public void Map_RandomOperations_MatchAModel()
    {
        var model = new Dictionary<int, int>();
        using var map = new NativeParallelHashMap<int, int>(1, Allocator.Persistent);
        var random = new Random(5);
        for (int step = 0; step < 20000; step++)
        {
            int key = random.Next(600) * 4096;
            Assert.That(map.TryAdd(key, step), Is.EqualTo(model.TryAdd(key, step)));
        }
        foreach (KeyValuePair<int, int> pair in model)
            Assert.That((map.ContainsKey(pair.Key), map[pair.Key]), Is.EqualTo((true, pair.Value)));
        Assert.That((map.TryGetValue(-1, out int missing), missing), Is.EqualTo((false, 0)));
        Assert.That(map.ContainsKey(-1), Is.False);
        Assert.That(() => map[-1], Throws.ArgumentException);
    }
}
#endif
