using FastPoints.Cli.Verbs;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using FastPoints.Surface;
using Random = Unity.Mathematics.Random;

namespace FastPoints.HostTests.Surface;

/// <summary>Edits of the cloud of <see cref="PointCloudColliderTests"/>, in cells of 20 m around its table; those of class 6
/// have no surface.</summary>
public sealed class SurfaceEditTests : ScratchTests
{
    const double Reach = 2; // Of a cell's margin, at these sizes of voxels and holes.

    static readonly SurfaceGrid s_grid = SurfaceColliders.GridOf(0.25f, 0.5f);
    static readonly double3 s_middle = new double3(500_000, 5_000_000, 100);

    string m_cloud;
    CloudManifest m_manifest;

    /// <summary>What would be shown of a cell are its bytes.</summary>
    sealed class Bytes(OpenedSurface opened, UnityLocalSpace space)
        : SurfaceColliders(opened, s_grid, ClassMask.Of(6), space)
    {
        protected override IEnumerator<JobStep> Show(SurfaceCell cell, PackedSurface surface)
        {
            Replace(cell, surface.Ints.ToArray());
            yield break;
        }

        protected override void Hide(SurfaceCell cell) { }
        protected override void Move(SurfaceCell cell) { }
    }

    [OneTimeSetUp]
    public void MakeCloud()
    {
        m_cloud = PointCloudColliderTests.Convert(Scratch["ground.fastpoints"], true);
        using var folder = CloudFolder.Open(m_cloud);
        m_manifest = folder.Manifest;
    }

    [SetUp]
    public void DropEdits() => File.Delete(EditJournal.PathOf(m_cloud));

    EditJournal Journal => EditJournal.Read(m_cloud, m_manifest.CloudId);

    SurfaceUpdates New(double radius)
    {
        var space = UnityLocalSpace.Of(m_manifest.BoundsGeo, m_manifest.Crs.Units);
        var near = new List<double3> { space.FromGeo(s_middle + new double3(-20, 0, 0)) };
        return new SurfaceUpdates(() => m_cloud, opened => new Bytes(opened, space), surface =>
        {
            surface.Follow(space, double4x4.identity, near, radius);
            return true;
        });
    }

    /// <summary>Goes on until all is made, and what is made anew stands until then. By cell: its bytes, null for none.</summary>
    static Dictionary<int3, int[]> Rest(SurfaceUpdates updates, int cacheMegabytes = 0)
    {
        var watch = System.Diagnostics.Stopwatch.StartNew();
        var standing = updates.Surface?.Cells.Made.ToArray() ?? [];
        do
        {
            updates.Update("a test", cacheMegabytes, 100);
            Assert.That(standing.All(cell => cell.IsMade), Is.True);
            Thread.Yield();
        }
        while ((updates.Surface == null || !updates.IsCurrent || updates.Surface.IsMaking || updates.Surface.IsWriting ||
            updates.Surface.Cells.Made.Count == 0 || updates.Surface.Cells.Next(double.MaxValue) != null) &&
            updates.Error == null && watch.ElapsedMilliseconds < 10_000);
        Assert.That(updates.Error, Is.Null);
        Assert.That(updates.Surface.Cells.Next(double.MaxValue), Is.Null);
        return updates.Surface.Cells.Made.ToDictionary(c => c.At, c => (int[])c.Collider);
    }

    double3 CornerOf(int3 cell) => m_manifest.Grid.ToGeo(m_manifest.Root.Corner) - s_middle +
        new double3(cell.x, cell.y, cell.z) * s_grid.CellMetres;

    static int CountOther(Dictionary<int3, int[]> a, Dictionary<int3, int[]> b) => a.Count(c => c.Value != b[c.Key]);

    EditOperation Box(double3 min, double3 max, EditAction action = EditAction.Delete)
    {
        var operation = new EditOperation { Action = action, Value = action == EditAction.Classify ? [6] : [] };
        operation.Boxes.Add(EditShape.Box(m_manifest.Grid, s_middle + min, s_middle + max));
        return operation;
    }

    /// <summary>And what it may reach, from the middle.</summary>
    (EditOperation Edit, double3 Min, double3 Max) RandomEdit(int kind, ref Random random)
    {
        var at = new double3(random.NextDouble2(new double2(-32, -10), new double2(2, 10)), 0);
        double size = random.NextDouble(0.3, 2);
        var (min, max) = (at - size, at + size);
        var edit = Box(min, max, (EditAction)random.NextInt(0, 3));
        if (kind == 0)
            return (edit, min, max);
        edit.Boxes.Clear();
        if (kind == 1 || kind == 2)
            edit.Balls.Add(EditVerb.Ball(m_manifest.Grid, s_middle + at, size));
        if (kind == 1)
            return (edit, min, max);
        if (kind == 5)
        {
            edit.Conditions.Add(FilterExpression.Parse("Classification == 2 && X < 499975"));
            return (edit, double.MinValue, double.MaxValue);
        }
        // A lasso from above, of kind 2 within the ball. It widens downwards if there is an eye.
        var corners = new[] { new double3(-1, -1, 0), new double3(1, -1, 0), new double3(0, 1, 0) }.Select(c =>
            s_middle + at + size * c).ToArray();
        var eye = kind == 4 ? new double4(s_middle + at + new double3(0, 0, 100), 1) : new double4(0, 0, 1, 0);
        Assert.That(edit.SetLasso(m_manifest.Grid, eye, corners), Is.Null);
        return (edit, new double3(at.xy - 1.3 * size, -100), new double3(at.xy + 1.3 * size, 100));
    }

    /// <summary>Cells are made anew where edits reach, and all of them have the bytes of the edited cloud's.</summary>
    [Test]
    public void Update_SeededEditsUndoneAndRedone_KeepsExactlyWhatTheyDoNotReach()
    {
        var random = new Random(7);
        var edits = new List<(EditOperation Edit, double3 Min, double3 Max)>();
        int applied = 0, kinds = 0, kept = 0, made = 0;
        var updates = New(11);
        var before = Rest(updates);
        for (int step = 0; step < 14; step++)
        {
            int kind = random.NextInt(0, 4);
            var (min, max) = (default(double3), default(double3));
            if (kind == 0 && applied > 0)
            {
                Assert.That(Journal.TryUndo(), Is.True);
                (_, min, max) = edits[--applied];
            }
            else if (kind == 1 && applied < edits.Count)
            {
                Assert.That(Journal.TryRedo(), Is.True);
                (_, min, max) = edits[applied++];
            }
            else
            {
                edits.RemoveRange(applied, edits.Count - applied);
                edits.Add(RandomEdit(kinds++ % 6, ref random));
                (var edit, min, max) = edits[applied++];
                Journal.Add(edit);
            }
            var after = Rest(updates);
            var anew = New(11);
            var wanted = Rest(anew);
            Assert.That(after.Keys, Is.EquivalentTo(wanted.Keys));
            foreach (var (at, bytes) in after)
            {
                Assert.That(bytes, Is.EqualTo(wanted[at]), "step " + step + ", cell " + at);
                var corner = CornerOf(at);
                bool isReached = math.all(max >= corner - Reach - 0.01) &&
                    math.all(min <= corner + s_grid.CellMetres + Reach + 0.01);
                Assert.That(isReached || bytes == before[at], Is.True, "step " + step + ", cell " + at + " is made anew");
                if (bytes != null)
                    (made, kept) = bytes == before[at] ? (made, kept + 1) : (made + 1, kept);
            }
            anew.Reopen();
            before = after;
        }
        updates.Reopen();
        Assert.That((kinds, made, kept), Is.EqualTo((9, 25, 31)), "edits, and cells with a surface");
    }

    [Test]
    public void Cells_OtherEditsReach_StandWhereSomebodyIsNearAndAreReadyIfTheyHaveGround()
    {
        var freed = new List<int3>();
        var cells = new SurfaceCells(s_grid, cell => freed.Add(cell.At));
        double3 unit = new double3(1, 1, 1), here = 0.5 * s_grid.CellMetres * unit, away = 1000 * unit;
        SurfaceCell Make(int triangles)
        {
            cells.Plan([here], unit, 1);
            var cell = cells.Next(0);
            cell.Collider = triangles > 0 ? new object() : null;
            cells.SetMade(cell, triangles, 1);
            return cell;
        }
        var made = Make(0);
        foreach (var (edits, isReady) in new[] { (1ul, true), (2ul, false), (1ul, true) })
        {
            cells.SetEdits(made, edits);
            Assert.That(cells.IsReady(here, default), Is.EqualTo(isReady), "no ground, of other edits");
            Assert.That(cells.Next(0), isReady ? Is.Null : Is.SameAs(made));
        }
        cells.SetEdits(made, 2);
        cells.Plan([away], unit, 1);
        made = Make(7);
        int version = cells.Version;
        cells.SetEdits(made, 2);
        cells.Plan([here], unit, 1);
        Assert.That((cells.IsReady(here, default), cells.Next(0), cells.Triangles), Is.EqualTo((true, made, 7)));
        cells.Plan([away], unit, 1);
        Assert.That((cells.Made.Count, cells.Triangles, made.Triangles), Is.EqualTo((0, 0, -1)), "nobody makes it anew");
        Assert.That((freed.Single(), cells.Version), Is.EqualTo((made.At, version + 1)));
    }

    [Test]
    public void Update_EditsBecomeUnreadable_KeepsWhatStands()
    {
        var updates = New(5);
        Journal.Add(Box(-1, 1));
        var before = Rest(updates);
        string journal = EditJournal.PathOf(m_cloud);
        byte[] whole = File.ReadAllBytes(journal), damaged = (byte[])whole.Clone();
        Journal.Add(Box(-2, 2));
        damaged[0] ^= 1;
        File.WriteAllBytes(journal, damaged);
        UnityEngine.Debug.s_sink = (type, text) => { };
        try
        {
            Assert.That(() =>
            {
                updates.Update("a test", 0, 100);
                return updates.Error;
            }, Does.Contain(journal).After(10_000, 1));
        }
        finally
        {
            UnityEngine.Debug.s_sink = null;
            File.WriteAllBytes(journal, whole);
        }
        Assert.That(updates.Surface.Cells.Made.ToDictionary(c => c.At, c => (int[])c.Collider), Is.EquivalentTo(before));
        updates.Reopen();
    }

    /// <summary>Without points, cells come from where they were.</summary>
    [Test]
    public void Update_EditFarAwayThenInAMargin_MakesTheReachedCellsAndUndoingFindsThemOnDisk()
    {
        var updates = New(5);
        var before = Rest(updates, 16);
        // Beside the margins of the last cells, then in them: outside of the cells either way.
        double end = CornerOf(before.Keys.Max(at => at.x) + 1).x + Reach;
        EditOperation Beside(double from) => Box(new double3(from, -20, -9), new double3(from + 0.5, 20, 9));
        Journal.Add(Beside(end + 0.02));
        Assert.That(CountOther(before, Rest(updates, 16)), Is.Zero);
        Journal.Add(Beside(end - 0.02));
        Assert.That(CountOther(before, Rest(updates, 16)), Is.Positive);

        var files = Directory.GetFiles(m_cloud, "*", SearchOption.AllDirectories).Where(f => new FileInfo(f).Length > 100_000)
            .ToDictionary(f => f, File.ReadAllBytes);
        foreach (var (file, bytes) in files)
            File.WriteAllBytes(file, new byte[bytes.Length]);
        try
        {
            Assert.That(Journal.TryUndo(), Is.True);
            var undone = Rest(updates, 16);
            Assert.That(undone, Is.EquivalentTo(before));
            Journal.Add(Beside(end + 0.02));
            Assert.That(CountOther(undone, Rest(updates, 16)), Is.Zero, "those of before stay");
            updates.Reopen();
            Assert.That(Rest(updates, 16), Is.EquivalentTo(before), "their files do");
        }
        finally
        {
            updates.Reopen();
            foreach (var (file, bytes) in files)
                File.WriteAllBytes(file, bytes);
        }
    }
}
