namespace Unity.Collections;

public enum NativeLeakDetectionMode { Disabled = 1, Enabled = 2, EnabledWithStackTrace = 3 }

public static class NativeLeakDetection
{
    public static NativeLeakDetectionMode Mode
    {
        get => AllocationLedger.Mode;
        set => AllocationLedger.Mode = value;
    }
}
