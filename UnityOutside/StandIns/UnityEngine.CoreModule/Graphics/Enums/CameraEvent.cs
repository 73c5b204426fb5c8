namespace UnityEngine.Rendering;

public enum CameraEvent { BeforeForwardOpaque = 10, AfterForwardOpaque = 11 }
