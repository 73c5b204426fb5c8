namespace UnityEngine.Rendering;

public enum IndexFormat { UInt16 = 0, UInt32 = 1 }

public enum BuiltinRenderTextureType
{
    PropertyName = -4,
    BufferPtr = -3,
    RenderTexture = -2,
    BindableTexture = -1,
    None = 0,
    CurrentActive = 1,
    CameraTarget = 2,
    Depth = 3,
}

public enum CameraEvent { BeforeForwardOpaque = 10, AfterForwardOpaque = 11 }

public enum GraphicsDeviceType
{
    Direct3D11 = 2,
    Null = 4,
    OpenGLES3 = 11,
    Metal = 16,
    OpenGLCore = 17,
    Direct3D12 = 18,
    Vulkan = 21,
    WebGPU = 28,
}

public enum GraphicsFenceType { AsyncQueueSynchronisation = 0, CPUSynchronisation = 1 }

[Flags]
public enum RTClearFlags { None = 0, Color = 1, Depth = 2, ColorDepth = 3, Stencil = 4, All = 7 }

public enum RenderBufferLoadAction { Load = 0, Clear = 1, DontCare = 2 }

public enum RenderBufferStoreAction { Store = 0, Resolve = 1, StoreAndResolve = 2, DontCare = 3 }

public enum RenderTextureSubElement { Color = 0, Depth = 1, Default = 3 }

public enum SynchronisationStageFlags
{
    VertexProcessing = 1,
    PixelProcessing = 2,
    ComputeProcessing = 4,
    AllGPUOperations = 7,
}

public enum TextureDimension { Unknown = -1, None = 0, Any = 1, Tex2D = 2, Tex3D = 3, Tex2DArray = 5 }
