namespace UnityEngine;

/// <summary>A host sets its matrices and its size; nothing is drawn by itself.</summary>
public sealed class Camera : Behaviour
{
    public delegate void CameraCallback(Camera cam);

    public enum StereoscopicEye { Left = 0, Right = 1 }
    public enum MonoOrStereoscopicEye { Left = 0, Right = 1, Mono = 2 }

    public static CameraCallback onPreCull;
    public static CameraCallback onPreRender;

    readonly List<(CameraEvent Event, CommandBuffer Commands)> m_commands = new List<(CameraEvent, CommandBuffer)>();
    Matrix4x4? m_view;

    /// <summary>The one that a host or a new scene made last.</summary>
    public static Camera main { get; internal set; }

    public CameraType cameraType { get; set; } = CameraType.Game;

    /// <summary>A bit for each layer; everything at first.</summary>
    public int cullingMask { get; set; } = -1;

    /// <summary>0 where the scene or the kind of camera says it.</summary>
    public ulong overrideSceneCullingMask { get; set; }

    public SceneManagement.Scene scene { get; set; }

    /// <summary>Of the transform without its scale, until it is set.</summary>
    public Matrix4x4 worldToCameraMatrix
    {
        get => m_view ?? Matrix4x4.Scale(new Vector3(1, 1, -1)) * Placed.inverse;
        set => m_view = value;
    }

    public Matrix4x4 projectionMatrix { get; set; } = Matrix4x4.identity;
    public float farClipPlane { get; set; } = 1000;

    /// <summary>A host's headset says it.</summary>
    public bool stereoEnabled { get; internal set; }

    public MonoOrStereoscopicEye stereoActiveEye { get; internal set; } = MonoOrStereoscopicEye.Mono;
    internal (Matrix4x4 View, Matrix4x4 Projection)[] Eyes { get; set; }

    /// <summary>Of a headset's eyes that are drawn in turn: the left one is in the camera's own target.</summary>
    internal RenderTexture RightEye { get; set; }

    Matrix4x4 Placed
    {
        get
        {
            var placed = transform.localToWorldMatrix;
            for (int axis = 0; axis < 3; axis++)
                placed.SetColumn(axis, ((Vector3)placed.GetColumn(axis)).normalized);
            return placed;
        }
    }

    public Matrix4x4 GetStereoViewMatrix(StereoscopicEye eye) => Eyes[(int)eye].View;
    public Matrix4x4 GetStereoProjectionMatrix(StereoscopicEye eye) => Eyes[(int)eye].Projection;

    public RenderTexture targetTexture { get; set; }

    /// <summary>A host's screen, where there is no <see cref="targetTexture"/>: its first row is the picture's topmost.</summary>
    internal RenderTexture Screen { get; set; }

    internal Rect? Part { get; set; } // The part of the screen that it draws into, from the lower left; null for all of it.

    internal float DynamicScale { get; set; } = 1;
    public int pixelWidth => (int)(Part?.width ?? (Target == null ? 0 : Target.width));
    public int pixelHeight => (int)(Part?.height ?? (Target == null ? 0 : Target.height));
    public int scaledPixelWidth => (int)(pixelWidth * DynamicScale);
    public int scaledPixelHeight => (int)(pixelHeight * DynamicScale);
    RenderTexture Target => targetTexture != null ? targetTexture : Screen;

    /// <summary>Through a pixel, from the near plane on.</summary>
    public Ray ScreenPointToRay(Vector3 pos)
    {
        Matrix4x4 toWorld = (projectionMatrix * worldToCameraMatrix).inverse;
        Vector3 At(float depth)
        {
            Vector4 place = toWorld * new Vector4(2 * pos.x / pixelWidth - 1, 2 * pos.y / pixelHeight - 1, depth, 1);
            return new Vector3(place.x, place.y, place.z) / place.w;
        }
        return new Ray(At(-1), At(1) - At(-1));
    }

    public void AddCommandBuffer(CameraEvent evt, CommandBuffer buffer) => m_commands.Add((evt, buffer));
    public CommandBuffer[] GetCommandBuffers(CameraEvent evt) =>
        m_commands.Where(c => c.Event == evt).Select(c => c.Commands).ToArray();

    public void RemoveCommandBuffer(CameraEvent evt, CommandBuffer buffer) => m_commands.Remove((evt, buffer));

    /// <summary>Its target cleared, then the command buffers: what the Built-in pipeline makes of a camera in a scene without
    /// meshes.</summary>
    public void Render()
    {
        if (RightEye == null)
        {
            onPreCull?.Invoke(this);
            RenderEye();
            return;
        }
        // Both are culled with the left one.
        stereoActiveEye = MonoOrStereoscopicEye.Left;
        onPreCull?.Invoke(this);
        RenderEye();
        var left = targetTexture;
        (stereoActiveEye, targetTexture) = (MonoOrStereoscopicEye.Right, RightEye);
        RenderEye();
        (stereoActiveEye, targetTexture) = (MonoOrStereoscopicEye.Left, left);
    }

    void RenderEye()
    {
        onPreRender?.Invoke(this);
        using var target = new CommandBuffer();
        // Both eyes of a headset, where they are drawn at once.
        int slice = stereoEnabled && Target.volumeDepth > 1 ? -1 : 0;
        target.SetRenderTarget(Target, Target, 0, CubemapFace.Unknown, slice);
        target.ClearRenderTarget(true, true, backgroundColor);
        Graphics.ExecuteCommandBuffer(target);
        target.Clear();
        // Each finds the camera's target and viewport set, whatever the one before it has drawn into.
        target.SetRenderTarget(BuiltinRenderTextureType.CameraTarget, BuiltinRenderTextureType.CameraTarget, 0,
            CubemapFace.Unknown, slice);
        if (Part is Rect part)
            target.SetViewport(new Rect(part.x, Target.IsScreen ? Target.height - part.y - part.height : part.y,
                scaledPixelWidth, scaledPixelHeight));
        Graphics.DrawPrimitives(this, target, Target);
        foreach (var (_, commands) in m_commands.OrderBy(c => c.Event))
            Graphics.Execute(target, commands, Target);
        Graphics.EndCamera();
    }

    public Color backgroundColor { get; set; }
}
