namespace StandIns.Graphics;

enum CommandKind : byte
{
    SetTarget,
    ClearTarget,
    SetViewport,
    SetViewProjection,
    SetGlobal,
    SetGlobalTexture,
    SetKeyword,
    SetConstant,
    SetKernelBuffer,
    SetKernelTexture,
    GetTemporary,
    ReleaseTemporary,
    SetInstanceMultiplier,
    Draw,
    DrawIndirect,
    Dispatch,
    DispatchIndirect,
    Upload,
    CopyBuffer,
    Fence,
    ReadBuffer,
    ReadTexture,
}

struct RecordedCommand
{
    internal CommandKind Kind;
    internal object X;
    internal object Y;
    internal object Z;
    internal GraphicsBuffer Indices;
    internal int A;
    internal int B;
    internal int C;
    internal int D;
    internal int Data;
}
