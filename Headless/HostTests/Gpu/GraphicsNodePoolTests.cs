namespace FastPoints.HostTests.Gpu;

public sealed class GraphicsNodePoolTests() : GpuCloudFixture(250_000)
{
    const int MaxFrames = 200_000;

    StreamContext Stream(long limitBytes, int bankBytes, int bytesPerUpload)
    {
        var stream = new StreamContext(new GraphicsNodePool(new GpuShaders().CopyPages, limitBytes, bankBytes));
        stream.Settings.Selection.MinScreenErrorPx = 0.1f;
        stream.Settings.MaxUploadBytesPerFrame = bytesPerUpload;
        var source = new FolderSource(CloudFolder.Open(CloudPath), StoreLayout.ColorName);
        stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
        return stream;
    }

    PictureCamera Above(StreamContext stream)
    {
        var source = stream.Clouds[0].Source;
        using var folder = CloudFolder.Open(CloudPath);
        var low = source.Grid.ToGeo(folder.Manifest.BoundsMin);
        var high = source.Grid.ToGeo(folder.Manifest.BoundsMax);
        var center = (low + high) / 2;
        var eye = center + new double3(0, 0, math.cmax(high - low) * 2);
        return PictureCamera.Perspective(eye, center, new double3(0, 1, 0), 60);
    }

    PictureCamera Near(StreamContext stream, double share, double heading)
    {
        var source = stream.Clouds[0].Source;
        using var folder = CloudFolder.Open(CloudPath);
        var low = source.Grid.ToGeo(folder.Manifest.BoundsMin);
        var high = source.Grid.ToGeo(folder.Manifest.BoundsMax);
        var eye = low + (high - low) * new double3(share, 1 - share, 0.7);
        return PictureCamera.Perspective(eye, eye + new double3(math.cos(heading), math.sin(heading), -0.5),
            new double3(0, 0, 1), 60);
    }

    static FrameStats Frame(StreamContext stream, PictureCamera camera)
    {
        using var views = new NativeArray<StreamView>(1, Allocator.Temp) { [0] = camera.ToStreamView(320, 180) };
        var stats = FrameStep.Run(stream, views);
        HeadlessGraphics.EndFrame();
        return stats;
    }

    static void Rest(StreamContext stream, PictureCamera camera)
    {
        int quiet = 0;
        for (int frame = 0; frame < MaxFrames && quiet < 10; frame++)
        {
            var stats = Frame(stream, camera);
            quiet = stats.ReadsInFlight == 0 && stats.RequestedNodes == 0 && stats.UploadedNodes == 0 ? quiet + 1 : 0;
            Thread.Yield();
        }
        Assert.That(quiet, Is.EqualTo(10), "streaming did not come to rest");
    }

    static void CheckBytes(StreamContext stream)
    {
        var pool = (GraphicsNodePool)stream.Pool;
        var source = stream.Clouds[0].Source;
        foreach (var nodes in stream.Drawn.AsArray().ToArray().GroupBy(d => d.Range.Bank))
        {
            var bank = new byte[pool.BankBytes];
            pool.BufferOf(nodes.Key).GetData(bank);
            foreach (var drawn in nodes)
            {
                byte[] file = File.ReadAllBytes(source.PlanesPathOf(drawn.Page));
                int at = drawn.Range.FirstPage * NodePool.PageBytes;
                for (int p = 0; p < source.Planes.Length; p++)
                {
                    var range = stream.Clouds[0].RangeOf(drawn.Page, drawn.Node, p);
                    Assert.That(bank.AsSpan(at, (int)range.LengthBytes).SequenceEqual(
                        file.AsSpan((int)range.OffsetBytes, (int)range.LengthBytes)), Is.True, "plane " + p);
                    at += (int)range.LengthBytes;
                }
            }
        }
    }

    /// <summary>The limit of a frame may change at any time.</summary>
    [Test]
    public unsafe void TryBeginUpload_LimitChanged_AllowsThatMuch()
    {
        const int Node = 1 << 20, Usual = 4 << 20;
        using var pool = new GraphicsNodePool(new GpuShaders().CopyPages, 64 << 20);
        foreach (int max in new[] { Usual, 9 << 20, 2 << 20, 0, Usual, Usual, 9 << 20 })
        {
            while (!pool.TryBeginUpload(max))
            {
                pool.BeginFrame();
                HeadlessGraphics.EndFrame();
            }
            int taken = 0;
            while (pool.TryAllocate(Node, out var run) && pool.ReserveForUpload(run, Node) != null)
                taken++;
            Assert.That(taken, Is.EqualTo(Math.Max(1, max / Node)));
            pool.EndUpload();
        }
    }

    [TestCase(1 << 18)]
    [TestCase(1 << 12)]
    public void Stream_WithTeleports_GpuMatchesTheFiles(int bytesPerUpload)
    {
        using var stream = Stream(3 << 19, 1 << 19, bytesPerUpload);
        int evicted = 0;
        for (int view = 0; view < 12; view++)
        {
            // Not all come to rest: uploads of one place end at the next.
            var camera = Near(stream, view / 11.0, view);
            if (view % 3 == 2)
                Rest(stream, camera);
            else
                for (int frame = 0; frame < 6; frame++)
                    evicted += Frame(stream, camera).EvictedNodes;
            CheckBytes(stream);
        }
        Assert.That(evicted, Is.GreaterThan(3));
        Assert.That(stream.Pool.FindProblem(), Is.Null);
    }

    [Test]
    public void Stream_GpuFarBehind_CopiesReadWhatWasWritten()
    {
        using var stream = Stream(3 << 19, 1 << 19, 1 << 16);
        int uploaded = 0;
        var wait = Stopwatch.StartNew();
        for (int step = 0; step < 400 || (uploaded <= 40 && wait.Elapsed < ImportProject.MaxWait); step++)
        {
            using var views = new NativeArray<StreamView>(1, Allocator.Temp)
            {
                [0] = Near(stream, step / 40 % 10 / 9.0, step / 40).ToStreamView(320, 180),
            };
            if (step % 7 != 3)
                uploaded += FrameStep.Run(stream, views).UploadedNodes;
            if (step % 100 < 60)
                HeadlessGraphics.EndFrame();
            Thread.Sleep(1);
        }
        Assert.That(uploaded, Is.GreaterThan(40));
        Rest(stream, Near(stream, 0.5, 1));
        CheckBytes(stream);
    }

    [Test]
    public void Stream_GpuWithoutFences_WaitsByFrames()
    {
        HeadlessGraphics.HasNoFences = true;
        HeadlessGraphics.FramesBehind = StagingRing.FramesInFlight;
        try
        {
            using var stream = Stream(3 << 19, 1 << 19, 1 << 16);
            var shaders = new GpuShaders();
            using var materials = new PointMaterials(shaders.Points, shaders.Compose);
            using var sizes = new SizeTree();
            using var renderer = new PointRenderer(materials, (GraphicsNodePool)stream.Pool, sizes);
            int uploaded = 0, uploads = 0;
            void Draw(StreamView view)
            {
                renderer.Prepare(stream, view, PointStyle.Default);
                HeadlessGraphics.EndFrame();
            }
            var wait = Stopwatch.StartNew();
            for (int step = 0; step < 400 || (uploaded <= 40 && wait.Elapsed < ImportProject.MaxWait); step++)
            {
                var view = Near(stream, step / 40 % 10 / 9.0, step / 40).ToStreamView(320, 180);
                using var views = new NativeArray<StreamView>(1, Allocator.Temp) { [0] = view };
                if (step % 7 != 3)
                {
                    int nodes = FrameStep.Run(stream, views).UploadedNodes;
                    uploaded += nodes;
                    uploads = step % 100 < 60 ? 0 : uploads + (nodes > 0 ? 1 : 0);
                }
                if (step % 100 < 60)
                    Draw(view);
                Assert.That(uploads, Is.LessThanOrEqualTo(StagingRing.FramesInFlight + 1), "without pictures: all buffers once");
                Thread.Yield();
            }
            Assert.That(uploaded, Is.GreaterThan(40));
            var last = Near(stream, 0.5, 1);
            for (int frame = 0, quiet = 0; quiet < 10; frame++)
            {
                Assert.That(frame, Is.LessThan(MaxFrames), "streaming did not come to rest");
                using var views = new NativeArray<StreamView>(1, Allocator.Temp) { [0] = last.ToStreamView(320, 180) };
                var stats = FrameStep.Run(stream, views);
                Draw(views[0]);
                quiet = stats.ReadsInFlight == 0 && stats.RequestedNodes == 0 && stats.UploadedNodes == 0 ? quiet + 1 : 0;
            }
            CheckBytes(stream);
        }
        finally
        {
            HeadlessGraphics.HasNoFences = false;
        }
    }

    [Test]
    public void LimitBytes_Lowered_FreesGpuMemory()
    {
        using var stream = Stream(4 << 20, 1 << 19, 1 << 18);
        stream.Settings.Selection.MinScreenErrorPx = 0;
        Rest(stream, Above(stream));
        long allocated = stream.Pool.AllocatedBytes, used = HeadlessGraphics.UsedBytes;
        Assert.That(allocated, Is.GreaterThan(1 << 20));
        stream.Pool.LimitBytes = 1 << 19;
        Rest(stream, Above(stream));
        HeadlessGraphics.WaitForIdle();
        Assert.That(stream.Pool.AllocatedBytes, Is.EqualTo(1 << 19));
        Assert.That(HeadlessGraphics.UsedBytes, Is.EqualTo(used - allocated + (1 << 19)));
        CheckBytes(stream);
    }

    /// <summary>At the end of play mode that is paused no frame comes in which Destroy would do it, and nobody else takes away
    /// what is not saved.</summary>
    [Test]
    public void Dispose_MaterialsInPlayMode_AreDestroyedAtOnce()
    {
        var shaders = new GpuShaders();
        var materials = new PointMaterials(shaders.Points, shaders.Compose);
        var style = PointStyle.Default;
        var made = new[] { materials.For(style, false, false, false), materials.ForCompose(ComposedFrom.Layer, style) };
        EditorApplication.isPlaying = true;
        try
        {
            materials.Dispose();
            Assert.That(made.Count(m => m != null), Is.Zero);
        }
        finally
        {
            EditorApplication.isPlaying = false;
        }
    }

    /// <summary>Once all has been made: what is drawn at once depends on when reads arrive, and a buffer may have to grow
    /// late. Garbage of a frame would be in every round. The safety checks of the test build remember each job, so that what
    /// schedules jobs is not looked at here: where their tables grow in one of the two lists, the difference of that round is
    /// not zero, below it too.</summary>
    [TestCase(false), TestCase(true)]
    public void Record_FrameAfterFrame_MakesNoGarbage(bool hasShadows)
    {
        using var stream = Stream(3 << 19, 1 << 19, 1 << 16);
        var shaders = new GpuShaders();
        using var materials = new PointMaterials(shaders.Points, shaders.Compose, hasShadows ? shaders.Raster : null);
        using var sizes = new SizeTree();
        using var renderer = new PointRenderer(materials, (GraphicsNodePool)stream.Pool, sizes);
        renderer.List.SetLook(0, new CloudLook { Plane = 1, Scale = 1 / 256.0, Light = hasShadows ? 1 : 0 });
        using var noSizes = new SizeTree();
        using var other = new DrawList(noSizes);
        using var commands = new UnityEngine.Rendering.CommandBuffer();
        var cameras = Enumerable.Range(0, 6).Select(i => Near(stream, i / 5.0, i)).ToArray();
        long Garbage(int frames)
        {
            long garbage = 0;
            for (int frame = 0; frame < frames; frame++)
            {
                var camera = cameras[frame / 10 % cameras.Length];
                Frame(stream, camera);
                var view = RenderViews.Of(camera, 320, 180, 0);
                view.Style = new PointStyle { Shape = PointShape.Disc, Size = PointSize.Adaptive(), EdlStrength = 0.25f };
                (view.Style.Shadows, view.Light) = (hasShadows, PointLighting.Default(new float3(0, 0, 1), new float3(0, 0, 1)));
                renderer.Prepare(stream, camera.ToStreamView(320, 180), view.Style);
                long before = GC.GetAllocatedBytesForCurrentThread();
                commands.Clear();
                renderer.Record(commands, view);
                garbage += GC.GetAllocatedBytesForCurrentThread() - before;
                // A depth map's list is the one job of recording.
                before = GC.GetAllocatedBytesForCurrentThread();
                if (hasShadows)
                    other.Build(stream, camera.ToStreamView(320, 180));
                garbage -= GC.GetAllocatedBytesForCurrentThread() - before;
            }
            return garbage;
        }
        long left = Garbage(600);
        for (int round = 0; round < 8 && left != 0; round++)
            left = Garbage(240);
        Assert.That(left, Is.Zero);
    }
}
