namespace UnityOutside.Tests.StandIns.Graphics;

public sealed class DrawTests : GraphicsFixture
{
    private const int Side = 32;
    private const uint Black = 0xff000000;
    private const uint Red = 0xff0000ff;
    private const uint Green = 0xff00ff00;
    private const uint Blue = 0xffff0000;

    private Shader m_shader;
    private Material m_material;
    private RenderTexture m_target;
    private GraphicsBuffer m_squares;
    private CommandBuffer m_commands;

    [OneTimeSetUp]
    public void Load() => m_shader = HeadlessShaders.Load(PathOf("Quads.shader"));

    [SetUp]
    public void Make()
    {
        m_material = new Material(m_shader);
        m_target = new RenderTexture(Side, Side, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat) { name = "target" };
        m_squares = Structured(2, 32);
        m_commands = new CommandBuffer { name = "draws" };
    }

    [TearDown]
    public void Free()
    {
        Object.DestroyImmediate(m_material);
        Object.DestroyImmediate(m_target);
        m_squares.Dispose();
        m_commands.Dispose();
    }

    // A square seen from 2 m with 90 degrees: it is as high as the picture where its size is 2.
    private void SetSquares(params (Vector3 Centre, float Size, Color Color)[] squares)
    {
        var data = new Vector4[4];
        for (int i = 0; i < squares.Length; i++)
        {
            data[2 * i] = new Vector4(squares[i].Centre.x, squares[i].Centre.y, squares[i].Centre.z, squares[i].Size);
            data[2 * i + 1] = squares[i].Color;
        }
        m_squares.SetData(data);
    }

    private void Begin()
    {
        m_commands.SetRenderTarget(m_target);
        m_commands.ClearRenderTarget(true, true, Color.black);
        m_commands.SetViewProjectionMatrices(Matrix4x4.identity, Matrix4x4.Perspective(90, 1, 0.1f, 100));
    }

    private uint[] Draw(int instances, MaterialPropertyBlock block = null)
    {
        m_material.SetBuffer(Id("_Squares"), m_squares);
        Begin();
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 0, MeshTopology.Triangles, 6, instances, block);
        Execute(m_commands);
        return Read<uint>(m_target);
    }

    // Row 0 is the lowest.
    private static uint At(uint[] texels, int x, int y) => texels[y * Side + x];

    [Test]
    public void Draw_UpAndRight_AreNotFlipped()
    {
        SetSquares((new Vector3(1, 1, -2), 1, Color.red));
        uint[] texels = Draw(1);
        Assert.That(At(texels, 24, 24), Is.EqualTo(Red));
        Assert.That(new[] { At(texels, 8, 24), At(texels, 24, 8), At(texels, 8, 8) }, Is.All.EqualTo(Black));
    }

    [TestCase(-2, -4, Red)]
    [TestCase(-4, -2, Green)]
    public void Draw_NearAndFarPoint_NearHidesFarInAnyOrder(float firstZ, float secondZ, uint expected)
    {
        SetSquares((new Vector3(0, 0, firstZ), 1, Color.red), (new Vector3(0, 0, secondZ), 1, Color.green));
        Assert.That(At(Draw(2), 16, 16), Is.EqualTo(expected));
    }

    [Test]
    public void Draw_Depth_IsOneNearAndZeroFar()
    {
        SetSquares((new Vector3(0.5f, 0, -0.1001f), 0.5f, Color.red));
        Draw(1);
        m_commands.Clear();
        var depth = new RenderTexture(Side, Side, GraphicsFormat.R32_SFloat, GraphicsFormat.None);
        m_commands.SetGlobalTexture(Id("_MainTex"), m_target, RenderTextureSubElement.Depth);
        m_commands.SetRenderTarget(depth);
        m_commands.ClearRenderTarget(false, true, Color.clear);
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 1, MeshTopology.Triangles, 3);
        Execute(m_commands);
        float[] texels = Read<float>(depth);
        Assert.That(texels[16 * Side + 31], Is.EqualTo(1).Within(0.01));
        Assert.That(texels[16 * Side], Is.Zero);
        Object.DestroyImmediate(depth);
    }

    [TestCase(0, true)]
    [TestCase(1, false)]
    [TestCase(2, true)]
    public void Draw_Cull_FrontIsClockwise(float cull, bool isSeen)
    {
        SetSquares((new Vector3(0, 0, -2), 1, Color.red));
        m_material.SetFloat(Id("_Cull"), cull);
        Assert.That(At(Draw(1), 16, 16), Is.EqualTo(isSeen ? Red : Black));
    }

    [Test]
    public void DrawIndirect_Counts_ComeFromTheBuffer()
    {
        SetSquares((new Vector3(-1, 0, -2), 0.5f, Color.red), (new Vector3(1, 0, -2), 0.5f, Color.blue));
        using var arguments =
            new GraphicsBuffer(GraphicsBuffer.Target.IndirectArguments, 2, GraphicsBuffer.IndirectDrawArgs.size);
        arguments.SetData(new[]
        {
            default(GraphicsBuffer.IndirectDrawArgs),
            new GraphicsBuffer.IndirectDrawArgs { vertexCountPerInstance = 6, instanceCount = 2 },
        });
        m_material.SetBuffer(Id("_Squares"), m_squares);
        Begin();
        m_commands.DrawProceduralIndirect(Matrix4x4.Translate(new Vector3(0, 1, 0)), m_material, 0, MeshTopology.Triangles,
            arguments,
            GraphicsBuffer.IndirectDrawArgs.size);
        Execute(m_commands);
        uint[] texels = Read<uint>(m_target);
        Assert.That((At(texels, 8, 24), At(texels, 24, 24), At(texels, 8, 16)), Is.EqualTo((Red, Blue, Black)));
    }

    [Test]
    public void Draw_PropertyBlock_IsCopiedAndOverridesTheMaterial()
    {
        SetSquares((new Vector3(0, 0, -2), 1, Color.white));
        var block = new MaterialPropertyBlock();
        block.SetVector(Id("_Tint"), Color.green);
        m_material.SetVector(Id("_Tint"), Color.red);
        Shader.SetGlobalVector(Id("_Tint"), Color.blue);
        m_material.SetBuffer(Id("_Squares"), m_squares);
        Begin();
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 0, MeshTopology.Triangles, 6, 1, block);
        block.Clear();
        Execute(m_commands);
        Assert.That(At(Read<uint>(m_target), 16, 16), Is.EqualTo(Green));
        m_commands.Clear();
        Assert.That(At(Draw(1), 16, 16), Is.EqualTo(Red));
    }

    [Test]
    public void Draw_GlobalBuffer_IsUsedIfTheMaterialHasNone()
    {
        SetSquares((new Vector3(0, 0, -2), 1, Color.green));
        Begin();
        m_commands.SetGlobalBuffer(Id("_Squares"), m_squares);
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 0, MeshTopology.Triangles, 6);
        Execute(m_commands);
        Assert.That(At(Read<uint>(m_target), 16, 16), Is.EqualTo(Green));
        Shader.SetGlobalBuffer(Id("_Squares"), null);
    }

    [Test]
    public void Draw_Keywords_LocalOnTheMaterialAndGlobalByCommand()
    {
        SetSquares((new Vector3(0, 0, -2), 1, Color.green));
        m_material.EnableKeyword("GREY");
        m_commands.EnableShaderKeyword("NEGATIVE");
        // Grey of the negative of green is black; a global keyword does not reach multi_compile_local.
        m_commands.DisableShaderKeyword("GREY");
        Assert.That(At(Draw(1), 16, 16), Is.EqualTo(Black));
        m_commands.Clear();
        m_commands.DisableShaderKeyword("NEGATIVE");
        Assert.That(At(Draw(1), 16, 16), Is.EqualTo(0xffffffffu));
        m_commands.Clear();
        m_material.DisableKeyword("GREY");
        Assert.That(At(Draw(1), 16, 16), Is.EqualTo(Green));
    }

    [Test]
    public void Draw_Viewport_IsFromTheLowerLeft()
    {
        SetSquares((new Vector3(0, 0, -2), 4, Color.red));
        m_material.SetBuffer(Id("_Squares"), m_squares);
        Begin();
        m_commands.SetViewport(new Rect(0, 0, Side / 2, Side / 4));
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 0, MeshTopology.Triangles, 6);
        Execute(m_commands);
        uint[] texels = Read<uint>(m_target);
        Assert.That((At(texels, 15, 7), At(texels, 15, 8), At(texels, 16, 7)), Is.EqualTo((Red, Black, Black)));
    }

    [Test]
    public void Draw_FromATemporaryTexture_BlendsOverTheTarget()
    {
        var half = new RenderTextureDescriptor(4, 4, GraphicsFormat.R16G16B16A16_SFloat, 0);
        m_material.SetVector(Id("_Tint"), new Vector4(1, 1, 1, 0.5f));
        m_commands.GetTemporaryRT(Id("_MainTex"), half, FilterMode.Point);
        m_commands.SetRenderTarget(Id("_MainTex"));
        m_commands.ClearRenderTarget(false, true, new Color(0, 2, 0, 1));
        m_commands.SetRenderTarget(m_target);
        m_commands.ClearRenderTarget(true, true, Color.red);
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 1, MeshTopology.Triangles, 3);
        m_commands.ReleaseTemporaryRT(Id("_MainTex"));
        Execute(m_commands);
        // Green is 1 before it is blended: what goes into eight bits is clamped first.
        uint texel = At(Read<uint>(m_target), 3, 3);
        Assert.That(new[] { texel & 0xff, texel >> 8 & 0xff, texel >> 24 }, Is.EqualTo(new[] { 128, 128, 128 }).Within(1));
    }

    [Test]
    public void Draw_UnboundTexture_IsMagenta()
    {
        SetSquares((new Vector3(0, 0, -2), 1, Color.green));
        m_material.SetBuffer(Id("_Squares"), m_squares);
        var fresh = new RenderTexture(4, 4, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.None);
        m_material.SetTexture(Id("_MainTex"), fresh);
        Begin();
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 0, MeshTopology.Triangles, 6);
        m_commands.SetViewport(new Rect(0, 0, 4, 4));
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 1, MeshTopology.Triangles, 3);
        Execute(m_commands);
        uint[] texels = Read<uint>(m_target);
        Assert.That((At(texels, 1, 1), At(texels, 16, 16)), Is.EqualTo((0xffff00ffu, Green)));
        Object.DestroyImmediate(fresh);
    }

    [Test]
    public void Draw_SrgbTarget_StoresLinearLightAsSrgb()
    {
        var target = new RenderTexture(4, 4, GraphicsFormat.R8G8B8A8_SRGB, GraphicsFormat.None);
        m_commands.SetRenderTarget(target);
        m_commands.ClearRenderTarget(false, true, new Color(0.2158605f, 0, 1, 1));
        Execute(m_commands);
        Assert.That(Read<uint>(target)[5], Is.EqualTo(0xffff0080u));
        Object.DestroyImmediate(target);
    }

    [Test]
    public void Draw_AllSlices_VertexShaderSelectsTheSlice()
    {
        SetSquares((default, 0, Color.red), (default, 0, Color.green));
        var eyes = new RenderTexture(new RenderTextureDescriptor(8, 8, GraphicsFormat.R8G8B8A8_UNorm, 32)
        {
            dimension = TextureDimension.Tex2DArray,
            volumeDepth = 2,
        });
        m_material.SetBuffer(Id("_Squares"), m_squares);
        m_commands.SetRenderTarget(new RenderTargetIdentifier(eyes, 0, CubemapFace.Unknown,
            RenderTargetIdentifier.AllDepthSlices));
        m_commands.ClearRenderTarget(true, true, Color.black);
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 2, MeshTopology.Triangles, 3, 2);
        Execute(m_commands);
        Assert.That((Read<uint>(eyes, 0)[9], Read<uint>(eyes, 1)[9]), Is.EqualTo((Red, Green)));
        Object.DestroyImmediate(eyes);
    }

    [Test]
    public void Draw_MissingBinding_IsNamed()
    {
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 0, MeshTopology.Triangles, 6);
        Assert.That(() => Execute(m_commands), Throws.InvalidOperationException.With.Message.Contains("no render target"));
        m_commands.Clear();
        Begin();
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 0, MeshTopology.Triangles, 6);
        Assert.That(() => Execute(m_commands), Throws.InvalidOperationException.With.Message.Contains("_Squares"));
        m_material.SetBuffer(Id("_Squares"), m_squares);
        m_squares.Dispose();
        Assert.That(() => Execute(m_commands), Throws.InvalidOperationException.With.Message.Contains("disposed"));
        m_commands.Clear();
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 0, MeshTopology.Quads, 4);
        m_commands.SetRenderTarget(Id("_Nothing"));
        Assert.That(() => Execute(m_commands), Throws.InvalidOperationException);
    }

    [Test]
    public void Draw_Points_AreOnePixelEach()
    {
        SetSquares((new Vector3(0.55f, 0.55f, -2), 0, Color.red), (new Vector3(-0.55f, -0.55f, -2), 0, Color.green));
        m_material.SetBuffer(Id("_Squares"), m_squares);
        Begin();
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 0, MeshTopology.Points, 1, 2);
        Execute(m_commands);
        uint[] texels = Read<uint>(m_target);
        Assert.That((At(texels, 20, 20), At(texels, 11, 11)), Is.EqualTo((Red, Green)));
        Assert.That(System.Array.FindAll(texels, t => t != Black).Length, Is.EqualTo(2));
    }

    [Test]
    public void Draw_PointsWithPsize_AreSoLargeAndBothStagesSeeTheBuffer()
    {
        SetSquares((new Vector3(0.1f, 0.1f, 0.5f), 3, Color.white));
        m_material.SetColor(Id("_Tint"), Color.red);
        m_material.SetBuffer(Id("_Squares"), m_squares);
        Begin();
        m_commands.DrawProcedural(Matrix4x4.identity, m_material, 3, MeshTopology.Points, 1);
        Execute(m_commands);
        uint[] texels = Read<uint>(m_target);
        Assert.That(System.Array.FindAll(texels, t => t == Red).Length, Is.EqualTo(9));
    }
}
